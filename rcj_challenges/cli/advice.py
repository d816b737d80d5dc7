"""Hints that ``run`` prints below a match and writes into logs: those of ``check``, without starting programs again."""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path

    from rcj_challenges.controllers.team import SuperTeam, Team
    from rcj_challenges.scenario.models.scenario import Scenario

_ONLY_SPECIAL = ("crash", "start", "protocol")
"""Faults whose general help adds nothing to the fault itself."""


def advice_on(
    scenario: Scenario,
    teams: Mapping[str, Team | SuperTeam],
    faults: Sequence[Mapping[str, Any]],
    standing: Sequence[str],
    logs: Path,
) -> list[dict[str, Any]]:
    """Return what to do about faults and robots that never moved, as in `HintResult`, and write it into their logs.

    Args:
        scenario: what was played.
        teams: by seat of the first half.
        faults: as in the result.
        standing: robots that did not fail and never moved.
        logs: folder with the robots' logs.
    """
    faults = [fault for fault in faults if fault["team"] in teams]
    if not faults and not standing:
        return []
    from rcj_challenges.checker.advice.hints import HELP_BY_FAULT, hint_for, read_log, standing_help, whereabouts_in

    numbers = {robot: number for seat in scenario.entrants.values() for number, robot in enumerate(seat.robots)}
    seats = {robot: seat for seat, entrant in scenario.entrants.items() for robot in entrant.robots}
    robots: dict[str, dict[str, None]] = {}
    for fault in faults:
        team = teams[fault["team"]].driving(numbers[fault["robot"]])
        log = read_log(logs, fault["robot"])
        hint = hint_for(scenario, team, fault, log, whereabouts_in(log))
        general = "" if fault["kind"] in _ONLY_SPECIAL else HELP_BY_FAULT.get(fault["kind"], "")
        if help_ := hint.help if hint is not None else general:
            robots.setdefault(help_, {})[fault["robot"]] = None
    for robot in standing:
        team = teams[seats[robot]].driving(numbers[robot])
        help_ = f"it did not move: {standing_help(scenario, team, robot, read_log(logs, robot))}"
        robots.setdefault(help_, {})[robot] = None
    hints = [{"robots": list(alike), "help": help_} for help_, alike in robots.items()]
    _write_into_logs(hints, logs)
    return hints


def _write_into_logs(hints: Sequence[Mapping[str, Any]], logs: Path) -> None:
    for hint in hints:
        for robot in hint["robots"]:
            # A full disk is no reason to keep back the result of a match.
            with contextlib.suppress(OSError), (logs / f"{robot}.log").open("a", encoding="utf-8") as log:
                log.write(f"hint: {hint['help']}\n")
