"""Stage *start*: every robot of either colour starts, finds its devices and answers its first steps."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import replace
from difflib import get_close_matches

from rcj_challenges.checker.failing import fault_findings
from rcj_challenges.checker.findings import Finding, Stage
from rcj_challenges.checker.hints import NO_DEVICE, NOTHING
from rcj_challenges.checker.others import looks_like, others_that_fit
from rcj_challenges.checker.rehearsal import Rehearsal, Rehearsed, rehearse
from rcj_challenges.controllers.team import Team
from rcj_challenges.facts.shown import shown
from rcj_challenges.facts.timing import TICK_S
from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.models.robots import Device
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.own_devices import devices_of
from rcj_challenges.scenario.resources import presets_folder

_TICKS = 4
"""Enough for two answers of a program that steps 64 ms."""

_SLOW_SHARE = 0.5
_MOST_DEVICES = 10
_PRESET_2021, _KIT_2021 = "soccersim_2021.yaml", "legacy_2021"
_MESSAGES_2021 = "2021"
# What `controller.Robot.getDevice` prints.
_Asked = dict[tuple[str, str], list[str]]
"""Robots by the name that they asked for in vain, and by what they have."""

_IGNORED = re.compile(r"^Warning: (\w+) is ignored and gives None", re.MULTILINE)


def check_start(rehearsal: Rehearsal) -> Stage:
    """Let the team take all seats that it can at once, for a few ticks.

    Raises:
        RcjError: it cannot be played for a reason that is not the team's.
    """
    stage = Stage("start")
    started = rehearse(rehearsal, tuple(rehearsal.seats()), _TICKS * TICK_S)
    asked = _asked_in_vain(started)
    stage.findings += _devices(asked, rehearsal)  # before what follows from it
    for finding in fault_findings("start", rehearsal, started):
        stage.findings.append(_because_of(asked, _ignored(started), finding))
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


def _asked_in_vain(started: Rehearsed) -> _Asked:
    asked: _Asked = {}
    for robot in started.motions:
        for found in dict.fromkeys(NO_DEVICE.findall(started.log(robot))):
            asked.setdefault(found, []).append(robot)
    return asked


def _ignored(started: Rehearsed) -> dict[str, list[str]]:
    """Return the calls of a supervisor that gave nothing, by robot."""
    return {robot: _IGNORED.findall(started.log(robot)) for robot in started.motions}


def _because_of(asked: _Asked, ignored: Mapping[str, list[str]], crash: Finding) -> Finding:
    """Return the finding on a crash, with what the program was not given if that may be the reason."""
    robots = set(crash.where.split(", "))
    missing = [name for (name, _), those in asked.items() if robots & set(those)]
    calls = [call for robot in robots for call in ignored.get(robot, ())]
    if NOTHING not in crash.message or not (missing or calls):
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
    scenario = rehearsal.loaded.scenario
    old = _devices_of_2021(rehearsal, {name for name, _ in asked}) if asked else {}
    findings = []
    for (name, has), robots in list(asked.items())[:_MOST_DEVICES]:
        message = f'asks for a device "{shown(name)}"; there is none'
        if name in old:
            message += ": this program seems to be written for the robots of 2021"
            remedy = _for_2021(rehearsal) + _instead(scenario, robots[0], old[name], has)
        else:
            near = get_close_matches(name, has.split(", "), 1)
            remedy = f'did you mean "{shown(near[0])}"?' if near else _all_of(has)
        findings.append(Finding("start.no_device", "warning", message, remedy, ", ".join(robots)))
    return findings


def _devices_of_2021(rehearsal: Rehearsal, asked: set[str]) -> Mapping[str, Device]:
    """Return the devices of the robots of 2021, if programs seem to be written for those, but play others; else none.

    All that they asked for in vain is of those robots then, and they mention no device that only others have.
    """
    scenario = rehearsal.loaded.scenario
    if _plays_2021(scenario):
        return {}
    devices = load(presets_folder() / _PRESET_2021).scenario.kits[_KIT_2021].devices
    others = {name for robot in scenario.robots for name in devices_of(scenario, robot)} - devices.keys()
    return devices if asked <= devices.keys() and not _mentions(rehearsal.team, others) else {}


def _plays_2021(scenario: Scenario) -> bool:
    return any(scenario.kits[robot.kit].messages == _MESSAGES_2021 for robot in scenario.robots.values())


def _for_2021(rehearsal: Rehearsal) -> str:
    """Return where programs of such a layout meet robots of 2021, as the beginning of a remedy."""
    names = others_that_fit(rehearsal.team.files, rehearsal.loaded.scenario, _plays_2021)
    return f"{looks_like(names)}; " if names else ""


def _mentions(team: Team, names: Iterable[str]) -> bool:
    """Return whether any of these names stands between quotation marks in a team's programs."""
    quoted = [mark + name.encode() + mark for name in names for mark in (b"'", b'"')]
    programs = [content for path, content in team.files.items() if path.suffix == ".py"]
    return any(name in program for program in programs for name in quoted)


def _instead(scenario: Scenario, robot: str, wanted: Device, has: str) -> str:
    """Return what a robot has in place of a device of the robots of 2021."""
    alike = [name for name, device in devices_of(scenario, robot).items() if device.device == wanted.device]
    if not alike or wanted.device != "supervisor_receiver":
        return _all_of(has)
    return f'here "{shown(alike[0])}" gets the referee\'s packets, without positions in them; {_all_of(has)}'


def _all_of(has: str) -> str:
    return f"these robots have: {shown(has, 400)}"
