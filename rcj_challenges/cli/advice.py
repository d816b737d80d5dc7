"""Hints that ``run`` prints below a match and writes into logs: those of ``check``, without starting programs again."""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING, Any

from rcj_challenges.core.sanitize import sanitize

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path

    from rcj_challenges.core.traffic import Note
    from rcj_challenges.scenario.models.scenario import Scenario
    from rcj_challenges.submissions.team import SuperTeam, Team

_ONLY_SPECIAL = ("crash", "start", "protocol")
"""Faults whose general help adds nothing to the fault itself."""


def advice_on(
    scenario: Scenario,
    teams: Mapping[str, Team | SuperTeam],
    faults: Sequence[Mapping[str, Any]],
    motionless: Sequence[str],
    notes: Mapping[str, Sequence[Note]],
    logs: Path,
) -> list[dict[str, Any]]:
    """Hints about faults, robots that never moved and refused calls, as in `HintResult`.

    Each log in the folder ``logs`` gets the hints for its robot as its last lines. The teams are by seat of the first
    half, the faults as in the result; the ``motionless`` robots did not fail and never moved.
    """
    faults = [fault for fault in faults if fault["team"] in teams]
    from rcj_challenges.checker.advice.hints import HELP_BY_FAULT, hint_for, read_log, standing_help, whereabouts_in

    numbers = {robot: number for seat in scenario.entrants.values() for number, robot in enumerate(seat.robots)}
    seats = {robot: seat for seat, entrant in scenario.entrants.items() for robot in entrant.robots}
    robots: dict[str, dict[str, None]] = {}
    for fault in faults:
        team = teams[fault["team"]].driving(numbers[fault["robot"]])
        whereabouts = whereabouts_in(read_log(logs, fault["robot"]))
        hint = hint_for(scenario, team, fault, notes.get(fault["robot"], ()), whereabouts)
        general = "" if fault["kind"] in _ONLY_SPECIAL else HELP_BY_FAULT.get(fault["kind"], "")
        if help_ := hint or general:
            robots.setdefault(help_, {})[fault["robot"]] = None
    for robot in motionless:
        team = teams[seats[robot]].driving(numbers[robot])
        help_ = f"it did not move: {standing_help(scenario, team, robot, notes.get(robot, ()))}"
        robots.setdefault(help_, {})[robot] = None
    for robot, seat in seats.items():
        known = " ".join(help_ for help_, alike in robots.items() if robot in alike)
        if seat in teams:
            team = teams[seat].driving(numbers[robot])
            for help_ in _warnings(scenario, team, robot, notes.get(robot, ()), known):
                robots.setdefault(help_, {})[robot] = None
    hints = [{"robots": list(alike), "help": help_} for help_, alike in robots.items()]
    _write_into_logs(hints, logs)
    return hints


def _warnings(scenario: Scenario, team: Team, robot: str, notes: Sequence[Note], known: str) -> list[str]:
    """What was refused or ignored, with what to do, as `check` has it; ``known``: hints that the robot has."""
    from rcj_challenges.checker.advice.devices import (
        MAX_COMPLAINTS,
        complaints_in,
        device_help,
        missing_devices,
        missing_sentence,
    )

    missing = missing_devices(notes)
    found = [
        (missing_sentence(name), device_help(scenario, team, robot, name, missing))
        for name in missing
        if f'"{sanitize(name)}"' not in known
    ]
    return [f"{what}: {help_}" for what, help_ in (found + complaints_in(notes))[:MAX_COMPLAINTS]]


def _write_into_logs(hints: Sequence[Mapping[str, Any]], logs: Path) -> None:
    for hint in hints:
        for robot in hint["robots"]:
            # A full disk is no reason to keep back the result of a match.
            with contextlib.suppress(OSError), (logs / f"{robot}.log").open("a", encoding="utf-8") as log:
                log.write(f"hint: {hint['help']}\n")
