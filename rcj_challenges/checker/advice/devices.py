"""Devices that a program requested and its robot lacks, and crashes that come from them."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping
from typing import Any

from rcj_challenges.checker.advice.table import Hint
from rcj_challenges.checker.others import others_that_fit, suggest_scenarios
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.core.similarity import nearest_name
from rcj_challenges.scenario.kit_devices import devices_of
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.submissions.team import Team

# What `controller` writes into a program's log when it returns None. A program may print such lines itself, as long as
# it likes, so the patterns are bounded.
_NO_DEVICE = re.compile(
    r'^Warning: "(?P<asked>.{0,300})" device not found\. This robot has: (?P<has>.{0,8000})\.$', re.MULTILINE
)
_IGNORED = re.compile(r"^Warning: (\w{1,100}) is ignored and gives None", re.MULTILINE)
# Methods of Webots' devices. Crashes over an unseen ball concern other attributes.
_METHOD_OF_NONE = re.compile(
    r"AttributeError: 'NoneType' object has no attribute '(?:(?:get|set|is|has|next|image|draw|fill|load|play|stop"
    r"|reset|remove|add|export|enable|disable)[A-Z]\w{0,100}|enable|disable|send)'"
)
_MAX_NAMED = 4


def missing_devices(log: str) -> dict[str, str]:
    """Return the missing names that a program requested, in order, each with the devices that the robot has."""
    return {found["asked"]: found["has"] for found in _NO_DEVICE.finditer(log)}


def missing_sentence(name: str) -> str:
    """Return the sentence about a program that requested a device of this name."""
    return f'asks for a device "{sanitize(name)}"; there is none'


def none_hint(scenario: Scenario, team: Team, fault: Mapping[str, Any], log: str) -> Hint | None:
    """Return the hint for a crash over None that was returned for a device or a call of a supervisor; else None.

    Args:
        scenario: what was played.
        team: whose program crashed.
        fault: as in the result.
        log: of the robot, or its beginning.
    """
    if not _METHOD_OF_NONE.search(fault["detail"]):
        return None
    missing, calls = missing_devices(log), list(dict.fromkeys(_IGNORED.findall(log)))
    names = [f'getDevice("{sanitize(name)}")' for name in missing] or calls
    if not names:
        return None
    named = " or ".join(names[:_MAX_NAMED])
    if not missing:
        help_ = "only a referee knows where things are; a player asks its own devices (gps, compass, ball receiver)"
    elif len(missing) > 1:
        help_ = _list_devices(next(iter(missing.values())))
    else:
        help_ = device_help(scenario, team, *next(iter(missing.items())), missing)
    return Hint("no_device", f"{named} returned None: {help_}")


def device_help(scenario: Scenario, team: Team, name: str, has: str, missing: Collection[str]) -> str:
    """Return what to do about a missing device that a program requested.

    Args:
        scenario: what was played.
        team: whose program.
        name: of the device.
        has: the devices that the robot has, as its log lists them.
        missing: all missing devices that the team's programs requested.
    """

    def has_all(other: Scenario) -> bool:
        return any(devices_of(other, robot).keys() >= set(missing) for robot in other.robots)

    if others := others_that_fit(team.files, scenario, has_all):
        return f"{suggest_scenarios(others)}; {_list_devices(has)}"
    near = nearest_name(name.casefold(), has.split(", "))
    return f'did you mean "{sanitize(near)}"?' if near is not None else _list_devices(has)


def _list_devices(has: str) -> str:
    return f"these robots have: {sanitize(has, 400)}"
