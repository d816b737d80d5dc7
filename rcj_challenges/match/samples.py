"""Sample teams, which play if no team was named."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from pathlib import Path

from rcj_challenges.scenario.kits import kit_of
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.resources import TEAMS_FOLDER
from rcj_challenges.submissions.team import TeamError, open_team

_OF_THE_MATCH = {"blue": "roles_and_radio", "yellow": "all_sensors"}
"""They understand the messages v2.1 and v2.2."""


def sample_team(scenario: Scenario, seat: str, bases: Sequence[Scenario] = ()) -> Path | None:
    """Return the folder of the sample team for a seat, None if none has programs for its robots.

    That is the team made for this scenario; else one made for a scenario that it extends, if the seat's robots have
    the same kits there, since a program of one kit cannot drive another; else one of the match's, unless the scenario
    gives robots of the match another kit. ``bases`` are the scenarios that it extends, the nearest first.
    """
    alike = [base.id for base in bases if not other_kits(scenario, base, seat)]
    fits = all(not other_kits(scenario, base, seat, either_message=True) for base in bases)
    of_the_match = _OF_THE_MATCH.get(seat) if fits else None
    for name in (scenario.id, *alike, of_the_match):
        if name is not None and _has_programs(TEAMS_FOLDER / name, scenario, seat):
            return TEAMS_FOLDER / name
    return None


def has_sample_team(scenario: Scenario) -> bool:
    """Return whether a sample team was made for this very scenario."""
    return (TEAMS_FOLDER / scenario.id).is_dir()


def other_kits(scenario: Scenario, base: Scenario, seat: str, *, either_message: bool = False) -> dict[str, str]:
    """Return the robots of a seat that have another kit, or other packets, in what is extended: that kit by robot.

    A robot that the base lacks has the kit "none" there. ``either_message``: v2.1 and v2.2 count as the same.
    """
    alike = {"v2.1", "v2.2"} if either_message else set()
    return {
        name: base.robots[name].kit if name in base.robots else "none"
        for name in scenario.entrants[seat].robots
        if name not in base.robots or _radio_layout(scenario, name, alike) != _radio_layout(base, name, alike)
    }


def _radio_layout(scenario: Scenario, robot: str, alike: Collection[str]) -> tuple[str, str, tuple[str, ...], bool]:
    """Return the name of a robot's kit, and the layout of its packets; messages that are ``alike`` count as one."""
    kit = kit_of(scenario, robot)
    return (
        scenario.robots[robot].kit,
        "alike" if kit.messages in alike else kit.messages,
        tuple(kit.packet_lists),
        kit.packet_has_flag,
    )


def _has_programs(folder: Path, scenario: Scenario, seat: str) -> bool:
    if not folder.is_dir():
        return False
    try:
        open_team(folder, scenario.entrants[seat])
    except TeamError:
        return False
    return True
