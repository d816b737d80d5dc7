"""Stage *start*: every robot of either colour starts, finds its devices and answers its first steps."""

from __future__ import annotations

import re
from difflib import get_close_matches

from rcj_challenges.checker.failing import fault_findings
from rcj_challenges.checker.findings import Finding, Stage
from rcj_challenges.checker.rehearsal import Rehearsal, Rehearsed, rehearse
from rcj_challenges.facts.shown import shown
from rcj_challenges.facts.timing import TICK_S

_TICKS = 4
"""Enough for two answers of a program that steps 64 ms."""

_SLOW_SHARE = 0.5
_MOST_DEVICES = 10
# What `controller.Robot.getDevice` prints.
_NO_DEVICE = re.compile(r'^Warning: "(?P<asked>.*)" device not found\. This robot has: (?P<has>.*)\.$', re.MULTILINE)


def check_start(rehearsal: Rehearsal) -> Stage:
    """Let the team take all seats that it can at once, for a few ticks.

    Raises:
        RcjError: it cannot be played for a reason that is not the team's.
    """
    stage = Stage("start")
    started = rehearse(rehearsal, tuple(rehearsal.seats()), _TICKS * TICK_S)
    stage.findings += fault_findings("start", started)
    stage.findings += _devices(started)
    slow = _slow(started, rehearsal.loaded.scenario.limits.start_s)
    if slow is not None:
        stage.findings.append(slow)
    if not stage.failed:
        longest_s = max((wait.started_s for wait in started.waits.values()), default=0.0)
        robots = ", ".join(started.motions)
        stage.findings.append(
            Finding(
                "start.ok", "passed", f"all robots start and answer, the slowest after {longest_s:.1f} s", "", robots
            )
        )
    return stage


def _slow(started: Rehearsed, limit_s: float) -> Finding | None:
    """Return a warning for programs that come near the limit; a slower computer would stop them."""
    slow = {robot: wait.started_s for robot, wait in started.waits.items() if wait.started_s > _SLOW_SHARE * limit_s}
    if not slow:
        return None
    return Finding(
        "start.slow",
        "warning",
        f"it takes {max(slow.values()):.0f} s until the first step; {limit_s:g} s are allowed",
        "prepare less before the first step: on a slower computer the program would be stopped",
        ", ".join(slow),
    )


def _devices(started: Rehearsed) -> list[Finding]:
    """Return a warning for each device that a program asked for in vain."""
    asked: dict[tuple[str, str], list[str]] = {}
    for robot in started.motions:
        for found in dict.fromkeys(_NO_DEVICE.findall(started.log(robot))):
            asked.setdefault(found, []).append(robot)
    findings = []
    for (name, has), robots in list(asked.items())[:_MOST_DEVICES]:
        near = get_close_matches(name, has.split(", "), 1)
        remedy = f'did you mean "{shown(near[0])}"?' if near else f"these robots have: {shown(has, 400)}"
        findings.append(
            Finding(
                "start.no_device",
                "warning",
                f'asks for a device "{shown(name)}"; there is none',
                remedy,
                ", ".join(robots),
            )
        )
    return findings
