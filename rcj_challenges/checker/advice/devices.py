"""Devices that a program requested and its robot lacks, and crashes that come from them."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping
from typing import Any

from rcj_challenges.checker.others import others_that_fit, suggest_scenarios
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.core.similarity import nearest_name
from rcj_challenges.core.traffic import Note
from rcj_challenges.scenario.kits import devices_of
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.submissions.team import Team

# Methods of Webots' devices. Crashes over an unseen ball concern other attributes.
_METHOD_OF_NONE = re.compile(
    r"AttributeError: 'NoneType' object has no attribute '(?:(?:get|set|is|has|next|image|draw|fill|load|play|stop"
    r"|reset|remove|add|export|enable|disable)[A-Z]\w{0,100}|enable|disable|send)'"
)
_MAX_NAMED = 4


MAX_COMPLAINTS = 5


def missing_devices(notes: Iterable[Note]) -> list[str]:
    """Return the missing names that a program requested, each once and in order."""
    return list(dict.fromkeys(note.subject for note in notes if note.code == "no-device"))


def complaints_in(notes: Iterable[Note]) -> list[tuple[str, str]]:
    """Calls that were refused or ignored, safe to show, and advice on them, each once and in order."""
    return list(dict.fromkeys((sanitize(note.message), sanitize(note.help)) for note in notes if note.help))


def missing_sentence(name: str) -> str:
    """Return the sentence about a program that requested a device of this name."""
    return f'asks for a device "{sanitize(name)}"; there is none'


def none_help(scenario: Scenario, team: Team, fault: Mapping[str, Any], notes: Iterable[Note]) -> str:
    """Advice on a crash over None that was returned for a device or a call of a supervisor; empty on any other."""
    if not _METHOD_OF_NONE.search(fault["detail"]):
        return ""
    missing = missing_devices(notes)
    calls = list(dict.fromkeys(sanitize(note.subject) for note in notes if note.code == "ignored-call"))
    names = [f'getDevice("{sanitize(name)}")' for name in missing] or calls
    if not names:
        return ""
    named = " or ".join(names[:_MAX_NAMED])
    if not missing:
        help_ = "only a referee knows where things are; a player asks its own devices (gps, compass, ball receiver)"
    elif len(missing) > 1:
        help_ = _list_devices(scenario, fault["robot"])
    else:
        help_ = device_help(scenario, team, fault["robot"], missing[0], missing)
    return f"{named} returned None: {help_}"


def device_help(scenario: Scenario, team: Team, robot: str, name: str, missing: Collection[str]) -> str:
    """Advice on a missing device that a program requested.

    Args:
        scenario: what was played.
        team: whose program.
        robot: that lacks it.
        name: of the device.
        missing: all missing devices that the team's programs requested.
    """

    def has_all(other: Scenario) -> bool:
        return any(devices_of(other, one).keys() >= set(missing) for one in other.robots)

    if others := others_that_fit(team.files, scenario, has_all):
        return f"{suggest_scenarios(others)}; {_list_devices(scenario, robot)}"
    near = nearest_name(name.casefold(), devices_of(scenario, robot))
    return f'did you mean "{sanitize(near)}"?' if near is not None else _list_devices(scenario, robot)


def _list_devices(scenario: Scenario, robot: str) -> str:
    return f"these robots have: {sanitize(', '.join(devices_of(scenario, robot)), 400)}"
