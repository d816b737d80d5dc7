"""Stage *start*: every robot of either colour starts, finds its devices and answers its first steps."""

from __future__ import annotations

from rcj_challenges.checker.codes import START_OK, START_SLOW
from rcj_challenges.checker.faults import MissingDevices, device_findings, fault_findings, missing_by_device
from rcj_challenges.checker.findings import Stage
from rcj_challenges.checker.rehearsal import Rehearsal, Rehearsed, rehearse
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.core.timing import TICK_S

_TICKS = 4
"""Enough for two answers of a program that steps 64 ms."""

_SLOW_SHARE = 0.5


def check_start(rehearsal: Rehearsal) -> tuple[Stage, Rehearsed, MissingDevices]:
    """Let the team take all seats that it can at once, for a few ticks.

    Returns:
        The findings, what was played, and the devices that the robots lack.

    Raises:
        RcjError: it cannot be played for a reason that is not the team's.
    """
    stage = Stage("start")
    started = rehearse(rehearsal, tuple(rehearsal.seats()), _TICKS * TICK_S)
    missing = missing_by_device(started)
    stage.findings += device_findings("start", missing, rehearsal)  # before what follows from it
    stage.findings += fault_findings("start", rehearsal, started)
    stage.findings += _slow(started, rehearsal.loaded.scenario.limits.start_s)
    if not stage.failed:
        longest_s = max((wait.started_s for wait in started.waits.values()), default=0.0)
        robots = ", ".join(started.robots)
        stage.findings.append(
            Diagnostic(START_OK, f"all robots start and answer, the slowest after {longest_s:.1f} s", where=robots)
        )
    return stage, started, missing


def _slow(started: Rehearsed, limit_s: float) -> list[Diagnostic]:
    """Return a warning for programs that come near the limit; a slower computer would stop them."""
    slow = {robot: wait.started_s for robot, wait in started.waits.items() if wait.started_s > _SLOW_SHARE * limit_s}
    if not slow:
        return []
    message = f"it takes {max(slow.values()):.0f} s until the first step; {limit_s:g} s are allowed"
    help_ = "prepare less before the first step: on a slower computer the program would be stopped"
    return [Diagnostic(START_SLOW, message, help_, ", ".join(slow))]
