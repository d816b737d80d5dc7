"""Devices that a program requested and its robot lacks: similar names, and whether a crash comes from one."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

from rcj_challenges.checker.advice.crash_site import OF_NONE, origins_of_none, programs
from rcj_challenges.checker.others import others_that_fit, suggest_scenarios
from rcj_challenges.controllers.team import Team
from rcj_challenges.core.likeness import nearest_name
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.devices.base import Device
from rcj_challenges.devices.supervisor_receiver import SupervisorReceiverDevice
from rcj_challenges.scenario.kit_devices import devices_of
from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.resources import presets_folder

# What `controller` writes into a program's log when it returns None. A program may print such lines itself, as long as
# it likes, so the patterns are bounded.
_NO_DEVICE = re.compile(
    r'^Warning: "(?P<asked>.{0,300})" device not found\. This robot has: (?P<has>.{0,8000})\.$', re.MULTILINE
)
_IGNORED = re.compile(r"^Warning: (\w{1,100}) is ignored and gives None", re.MULTILINE)
# Methods of Webots' devices. Crashes over an unseen ball concern other attributes.
_OF_DEVICES = re.compile(
    r"(?:get|set|is|has|next|image|draw|fill|load|play|stop|reset|remove|add|export|enable|disable)[A-Z]\w*"
    r"|enable|disable|send"
)
_ASKS = r"get(?:Device|Motor|Receiver|Emitter|GPS|Compass|DistanceSensor|PositionSensor|Lidar|Camera|LED|Gyro)\("
_ASKS_BY_NAME = re.compile(_ASKS + r"[ \t]{0,4}([\"'])[^\"']{0,100}\1[ \t]{0,4}\)")
_MAX_NAMED = 4
_OF_2021, _SINCE = "2021", "2022 and later"
_KITS = {_OF_2021: ("soccersim_2021.yaml", "legacy_2021"), _SINCE: ("soccersim_v2.yaml", "v2")}
"""By years: where their robots are described."""


def missing_devices(log: str) -> dict[str, str]:
    """Return the missing names that a program requested, in order, each with the devices that the robot has."""
    return {found["asked"]: found["has"] for found in _NO_DEVICE.finditer(log)}


def none_hint(scenario: Scenario, team: Team, robot: str, detail: str, log: str) -> str:
    """Return help for a crash over None that was returned for a device or a call of a supervisor; else empty.

    Args:
        scenario: what was played.
        team: whose program crashed.
        robot: its name.
        detail: the last line of the traceback.
        log: of the robot, or its beginning.
    """
    found = OF_NONE.search(detail)
    missing, calls = missing_devices(log), list(dict.fromkeys(_IGNORED.findall(log)))
    if found is None or not (missing or calls):
        return ""
    origins = origins_of_none(detail, team.files)
    named = [name for name in missing if any(mark + name + mark in origins for mark in "\"'")]
    if not named:
        called = [call for call in calls if f"{call}(" in origins] or ([] if missing else calls)
        if called:
            others = "a player asks its own devices (gps, compass, ball receiver)"
            return f"{_list_calls(called)} returned None: only a referee knows where things are; {others}"
        if not _may_be_a_device(origins, found["attribute"]):
            return ""
    names = named or list(missing)
    advice = DeviceAdvice(scenario, team, missing)
    made_for = advice.made_for(names[-1])
    single = len(names) == 1 or made_for
    remedy = advice.remedy(names[-1], robot, missing[names[-1]]) if single else _all_of(missing[names[-1]])
    quoted = _list_calls([f'getDevice("{sanitize(name)}")' for name in names])
    return f"{quoted} returned None: {made_for + '; ' if made_for else ''}{remedy}"


def _may_be_a_device(origins: str, attribute: str) -> bool:
    """Return whether None may come from a device: not if another one was requested there, or it was set to None."""
    if _ASKS_BY_NAME.search(origins) or re.search(r"=[ \t]{0,4}None\b", origins):
        return False
    return re.search(_ASKS, origins) is not None or _OF_DEVICES.fullmatch(attribute) is not None


def _list_calls(calls: Sequence[str]) -> str:
    return " or ".join([*calls[:_MAX_NAMED], *["another"] * (len(calls) > _MAX_NAMED)])


class DeviceAdvice:
    """Help for missing devices that a team's programs requested.

    Args:
        scenario: what was played.
        team: whose programs.
        names: all names that they asked for in vain.
    """

    def __init__(self, scenario: Scenario, team: Team, names: Iterable[str]) -> None:
        self._scenario = scenario
        self._team = team
        self._years = _SINCE if _plays_2021(scenario) else _OF_2021
        self._missing = set(names)
        self._theirs = _devices_of_other_years(scenario, team, self._missing, self._years)

    def made_for(self, name: str) -> str:
        """Return the robots for which the programs seem to be written, if those have the device; else empty."""
        return f"this program seems to be written for the robots of {self._years}" if name in self._theirs else ""

    def remedy(self, name: str, robot: str, has: str) -> str:
        """Return what to do about one of them.

        Args:
            name: of the device.
            robot: that does not have it.
            has: the devices that it has, as its log lists them.
        """
        if name in self._theirs:
            of_2021 = self._years == _OF_2021
            fits = others_that_fit(self._team.files, self._scenario, lambda other: _plays_2021(other) == of_2021)
            return self._format_others(fits) + _in_place(self._scenario, robot, self._theirs[name], has)
        near = nearest_name(name.casefold(), has.split(", "))
        if near is not None:
            return f'did you mean "{sanitize(near)}"?'
        return self._format_others(others_that_fit(self._team.files, self._scenario, self._has_all)) + _all_of(has)

    def _format_others(self, names: Sequence[str]) -> str:
        return f"{suggest_scenarios(names)}; " if names else ""

    def _has_all(self, other: Scenario) -> bool:
        """Return whether a robot of another scenario has everything that was asked for in vain."""
        return any(self._missing <= devices_of(other, robot).keys() for robot in other.robots)


def _devices_of_other_years(scenario: Scenario, team: Team, missing: set[str], years: str) -> Mapping[str, Device]:
    """Return the devices of the robots of some years if the programs seem to be written for those; else none.

    Then all that they asked for in vain belongs to those robots, and they mention no device that only these have.
    """
    if not missing:
        return {}
    preset, kit = _KITS[years]
    devices = load(presets_folder() / preset).scenario.kits[kit].devices
    others = {name for robot in scenario.robots for name in devices_of(scenario, robot)} - devices.keys()
    quoted = [mark + name.encode() + mark for name in others for mark in (b"'", b'"')]
    mentioned = any(name in program for program in programs(team.files) for name in quoted)
    return devices if missing <= devices.keys() and not mentioned else {}


def _plays_2021(scenario: Scenario) -> bool:
    return any(scenario.kits[robot.kit].messages == _OF_2021 for robot in scenario.robots.values())


def _in_place(scenario: Scenario, robot: str, wanted: Device, has: str) -> str:
    """Return what a robot has in place of a device of the robots of other years."""
    devices = devices_of(scenario, robot).items()
    alike = [name for name, device in devices if isinstance(device, SupervisorReceiverDevice)]
    if not alike or not isinstance(wanted, SupervisorReceiverDevice):
        return _all_of(has)
    positions = "with" if _plays_2021(scenario) else "without"
    return f'here "{sanitize(alike[0])}" gets the referee\'s packets, {positions} positions in them; {_all_of(has)}'


def _all_of(has: str) -> str:
    return f"these robots have: {sanitize(has, 400)}"
