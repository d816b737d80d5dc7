"""Stage *start*: every robot of either colour starts, finds its devices and answers its first steps."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace

from rcj_challenges.checker.advice.no_device import InsteadOf, asked_in_vain, is_of_a_device
from rcj_challenges.checker.failing import fault_findings
from rcj_challenges.checker.findings import Finding, Stage
from rcj_challenges.checker.rehearsal import Rehearsal, Rehearsed, rehearse
from rcj_challenges.controllers.team import Team
from rcj_challenges.facts.shown import shown
from rcj_challenges.facts.timing import TICK_S

_TICKS = 4
"""Enough for two answers of a program that steps 64 ms."""

_SLOW_SHARE = 0.5
_MOST_DEVICES = 10
_Asked = dict[tuple[str, str], list[str]]
"""Robots by the name that they asked for in vain, and by what they have."""

_IGNORED = re.compile(r"^Warning: (\w+) is ignored and gives None", re.MULTILINE)


@dataclass(frozen=True)
class Started:
    """The stage and what it rests on.

    Attributes:
        stage: findings.
        match: the few ticks that were played.
    """

    stage: Stage
    match: Rehearsed


def check_start(rehearsal: Rehearsal) -> Started:
    """Let the team take all seats that it can at once, for a few ticks.

    Raises:
        RcjError: it cannot be played for a reason that is not the team's.
    """
    stage = Stage("start")
    started = rehearse(rehearsal, tuple(rehearsal.seats()), _TICKS * TICK_S)
    asked = _asked_in_vain(started)
    stage.findings += _devices(asked, rehearsal)  # before what follows from it
    for finding in fault_findings("start", rehearsal, started):
        stage.findings.append(_because_of(asked, _ignored(started), rehearsal.team, finding))
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
    return Started(stage, started)


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


def _asked_in_vain(started: Rehearsed) -> _Asked:
    asked: _Asked = {}
    for robot in started.motions:
        for found in asked_in_vain(started.log(robot)).items():
            asked.setdefault(found, []).append(robot)
    return asked


def _ignored(started: Rehearsed) -> dict[str, list[str]]:
    """Return the calls of a supervisor that gave nothing, by robot."""
    return {robot: _IGNORED.findall(started.log(robot)) for robot in started.motions}


def _because_of(asked: _Asked, ignored: Mapping[str, list[str]], team: Team, crash: Finding) -> Finding:
    """Return the finding on a crash, with what the program was not given if that may be the reason."""
    robots = set(crash.where.split(", "))
    missing = [name for (name, _), those in asked.items() if robots & set(those)]
    calls = [call for robot in robots for call in ignored.get(robot, ())]
    if not (missing or calls) or not is_of_a_device(crash.message, team):
        return crash
    if not missing:
        return replace(
            crash,
            remedy=f"{calls[-1]} gave None: only a referee is told where things are; a player asks its own devices "
            "(gps, compass, ball receiver)",
        )
    return replace(
        crash, remedy=f'getDevice("{shown(missing[-1])}") gave None, see above: ask for a device that there is'
    )


def _devices(asked: _Asked, rehearsal: Rehearsal) -> list[Finding]:
    """Return a warning for each device that a program asked for in vain."""
    instead = InsteadOf(rehearsal.loaded.scenario, rehearsal.team, [name for name, _ in asked])
    findings = []
    for (name, has), robots in list(asked.items())[:_MOST_DEVICES]:
        message = f'asks for a device "{shown(name)}"; there is none'
        if made_for := instead.made_for(name):
            message += f": {made_for}"
        remedy = instead.remedy(name, robots[0], has)
        findings.append(Finding("start.no_device", "warning", message, remedy, ", ".join(robots)))
    return findings
