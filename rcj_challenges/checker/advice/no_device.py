"""What a program asked for in vain, a device mostly: what it may have meant, and whether a crash comes of it."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

from rcj_challenges.checker.advice.crash_lines import OF_NONE, set_in, used_none
from rcj_challenges.checker.others import looks_like, others_that_fit
from rcj_challenges.controllers.team import Team
from rcj_challenges.facts.likeness import nearest_name
from rcj_challenges.facts.shown import shown
from rcj_challenges.scenario.load import load
from rcj_challenges.scenario.models.robots import Device
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.own_devices import devices_of
from rcj_challenges.scenario.resources import presets_folder

# What `controller.Robot.getDevice` writes into a program's log when it gives None.
# A program may print such lines itself, as long ones as it likes: in them the search could take for ever.
_NO_DEVICE = re.compile(
    r'^Warning: "(?P<asked>.{0,300})" device not found\. This robot has: (?P<has>.{0,8000})\.$', re.MULTILINE
)
# And what its Supervisor writes.
_IGNORED = re.compile(r"^Warning: (\w{1,100}) is ignored and gives None", re.MULTILINE)
# Methods of Webots' devices, also of those that no robot here has. Of a ball that is not in sight others are asked.
_OF_DEVICES = re.compile(
    r"(?:get|set|is|has|next|image|draw|fill|load|play|stop|reset|remove|add|export|enable|disable)[A-Z]\w*"
    r"|enable|disable|send"
)
_ASKS = rb"get(?:Device|Motor|Receiver|Emitter|GPS|Compass|DistanceSensor|PositionSensor|Lidar|Camera|LED|Gyro)\("
_ASKS_BY_NAME = re.compile(_ASKS.decode() + r"[ \t]{0,4}([\"'])[^\"']{0,100}\1[ \t]{0,4}\)")
_MOST_NAMED = 4
_MOST_CALLS = 50  # a supervisor has fewer; a program may print what it likes
_OF_2021, _SINCE = "2021", "2022 and later"
_KITS = {_OF_2021: ("soccersim_2021.yaml", "legacy_2021"), _SINCE: ("soccersim_v2.yaml", "v2")}
"""Of the years: where their robots are described."""
_MESSAGES_2021 = "2021"


def asked_in_vain(log: str) -> dict[str, str]:
    """Return the names that a program asked for in vain, in order, each with what the robot has instead.

    Args:
        log: of the robot, or its beginning.
    """
    return {found["asked"]: found["has"] for found in _NO_DEVICE.finditer(log)}


def ignored_calls(log: str) -> list[str]:
    """Return the calls of a supervisor that gave nothing, in order, each once.

    Args:
        log: of the robot, or its beginning.
    """
    return list(dict.fromkeys(_IGNORED.findall(log)))[:_MOST_CALLS]


@dataclass(frozen=True)
class GivenNone:
    """What a program that crashed over None was given it for.

    Attributes:
        told: that it was so, as a sentence begins.
        devices: the names among which the one is; none if it was a call of a supervisor.
    """

    told: str
    devices: tuple[str, ...] = ()


def behind_none(detail: str, team: Team, asked: Collection[str], calls: Sequence[str]) -> GivenNone | None:
    """Return what a program was given None for, if its crash is that of one that takes it for a device.

    Args:
        detail: the last line of what the program told of its end.
        team: whose program it is.
        asked: all names of devices that it asked for in vain.
        calls: all calls of a supervisor that gave nothing.
    """
    if not (asked or calls) or not is_of_a_device(detail, team):
        return None
    line, holder = used_none(detail, team.files)
    origins = "\n".join([line, *set_in(holder, team.files)])
    devices = [name for name in asked if any(mark + name + mark in origins for mark in "\"'")]
    if calls and not devices:
        called = [call for call in calls if re.search(rf"\b{call}\(", origins)]
        if called or not asked:
            # The others of a supervisor's calls are there for what they do.
            return GivenNone(_gave_none(called[-1:] or [one for one in calls if one.startswith("get")] or calls))
    if not devices and _ASKS_BY_NAME.search(origins):
        return None  # that one is there
    devices = devices or list(asked)
    return GivenNone(_gave_none([f'getDevice("{shown(name)}")' for name in devices]), tuple(devices))


def _gave_none(calls: Sequence[str]) -> str:
    """Return which call it was, as a sentence begins; of several, that it is one of them."""
    *first, last = dict.fromkeys(calls)
    if not first:
        return f"{last} gave None"
    others = "another" if len(first) >= _MOST_NAMED else last
    return f"this None comes from {', '.join(first[:_MOST_NAMED])} or {others}"


def is_of_a_device(detail: str, team: Team) -> bool:
    """Return whether a crash is that of a program that takes None for a device, and not for something of its own.

    Args:
        detail: the last line of what the program told of its end.
        team: whose program it is.
    """
    found = OF_NONE.search(detail)
    if found is None:
        return False
    attribute = found["attribute"]
    holder = used_none(detail, team.files)[1].encode()
    # Up to the next "=" alone: of a line full of them each would be looked at as often as there are letters.
    if holder and _any_program_has(rb"\b%b[ \t]{0,4}=[^\n=]{0,200}?%b" % (holder, _ASKS), team):
        return True
    if not _OF_DEVICES.fullmatch(attribute):
        return False
    if holder and _any_program_has(rb"\b%b[ \t]{0,4}=[ \t]{0,4}None\b" % holder, team):
        return False  # which the program set itself
    return not _any_program_has(rb"\bdef[ \t]{1,4}%b\b" % attribute.encode(), team)


def _any_program_has(words: bytes, team: Team) -> bool:
    return any(path.suffix == ".py" and re.search(words, content) for path, content in team.files.items())


class InsteadOf:
    """What to do about devices that a team's programs asked for in vain.

    Args:
        scenario: what was played.
        team: whose programs.
        names: all that they asked for in vain.
    """

    def __init__(self, scenario: Scenario, team: Team, names: Iterable[str]) -> None:
        self._scenario = scenario
        self._team = team
        self._years = _SINCE if _plays_2021(scenario) else _OF_2021
        self._asked = set(names)
        self._theirs = _devices_of_other_years(scenario, team, self._asked, self._years)

    def made_for(self, name: str) -> str:
        """Return for which robots the programs seem to be written, if those have it; else nothing."""
        return f"this program seems to be written for the robots of {self._years}" if name in self._theirs else ""

    def remedy(self, name: str, robot: str, has: str) -> str:
        """Return what to do about one of them.

        Args:
            name: of the device.
            robot: that has not got it.
            has: the devices that it has, as its log lists them.
        """
        if name in self._theirs:
            meant = self._scenarios_of_their_years()
            return meant + _in_place(self._scenario, robot, self._theirs[name], has)
        near = nearest_name(name.casefold(), has.split(", "))
        if near is not None:
            return f'did you mean "{shown(near)}"?'
        others = others_that_fit(self._team.files, self._scenario, self._are_of)
        return (f"{looks_like(others)}; " if others else "") + _all_of(has)

    def _are_of(self, other: Scenario) -> bool:
        """Return whether a robot of another scenario has all that was asked for in vain."""
        return any(self._asked <= devices_of(other, robot).keys() for robot in other.robots)

    def _scenarios_of_their_years(self) -> str:
        """Return where programs of such a layout meet the robots that they were written for, as a remedy begins."""
        of_2021 = self._years == _OF_2021
        names = others_that_fit(self._team.files, self._scenario, lambda other: _plays_2021(other) == of_2021)
        return f"{looks_like(names)}; " if names else ""


def _devices_of_other_years(scenario: Scenario, team: Team, asked: set[str], years: str) -> Mapping[str, Device]:
    """Return the devices of the robots of some years, if programs seem to be written for those, not these; else none.

    All that they asked for in vain is of those robots then, and they mention no device that only these have.
    """
    if not asked:
        return {}
    preset, kit = _KITS[years]
    devices = load(presets_folder() / preset).scenario.kits[kit].devices
    others = {name for robot in scenario.robots for name in devices_of(scenario, robot)} - devices.keys()
    return devices if asked <= devices.keys() and not _mentions(team, others) else {}


def _plays_2021(scenario: Scenario) -> bool:
    return any(scenario.kits[robot.kit].messages == _MESSAGES_2021 for robot in scenario.robots.values())


def _mentions(team: Team, names: Iterable[str]) -> bool:
    """Return whether any of these names stands between quotation marks in a team's programs."""
    quoted = [mark + name.encode() + mark for name in names for mark in (b"'", b'"')]
    programs = [content for path, content in team.files.items() if path.suffix == ".py"]
    return any(name in program for program in programs for name in quoted)


def _in_place(scenario: Scenario, robot: str, wanted: Device, has: str) -> str:
    """Return what a robot has in place of a device of the robots of other years."""
    alike = [name for name, device in devices_of(scenario, robot).items() if device.device == wanted.device]
    if not alike or wanted.device != "supervisor_receiver":
        return _all_of(has)
    positions = "with" if _plays_2021(scenario) else "without"
    return f'here "{shown(alike[0])}" gets the referee\'s packets, {positions} positions in them; {_all_of(has)}'


def _all_of(has: str) -> str:
    return f"these robots have: {shown(has, 400)}"
