"""What ``run`` says of programs that failed beyond their faults, as far as it shows without starting them again."""

from __future__ import annotations

import contextlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Mapping, Sequence
    from pathlib import Path

    from rcj_challenges.controllers.super_team import SuperTeam
    from rcj_challenges.controllers.team import Team
    from rcj_challenges.scenario.models.scenario import Scenario

_BEGINNING = 100_000  # letters
_STANDS = (
    "it did not move: if it waits on purpose, all is well; "
    'else call setPosition(float("inf")) and setVelocity on both motors'
)


def advice_on(
    scenario: Scenario, teams: Mapping[str, Team | SuperTeam], faults: Sequence[Mapping[str, Any]], logs: Path
) -> list[dict[str, Any]]:
    """Return what to do about faults, where that shows, as in `HintResult`, and write it into the robots' logs.

    The words are those of ``check``.

    Args:
        scenario: what was played.
        teams: who played, by seat of the first half.
        faults: as in the result.
        logs: folder with the robots' logs.
    """
    ended = [fault for fault in faults if fault["kind"] in ("crash", "exit") and fault["team"] in teams]
    if not ended:
        return []
    from rcj_challenges.checker.advice.hints import hint_for

    numbers = {robot: number for seat in scenario.entrants.values() for number, robot in enumerate(seat.robots)}
    robots: dict[str, dict[str, None]] = {}
    for fault in ended:
        team = teams[fault["team"]].driving(numbers[fault["robot"]])
        hint = hint_for(scenario, team, fault, _beginning(logs, fault["robot"]))
        if hint is not None:
            robots.setdefault(hint.remedy, {})[fault["robot"]] = None
    hints = [{"robots": list(alike), "remedy": remedy} for remedy, alike in robots.items()]
    _write_into_logs(hints, logs)
    return hints


def advice_on_standing(robots: Sequence[str], faults: Sequence[Mapping[str, Any]], logs: Path) -> list[dict[str, Any]]:
    """Return what to do about robots that never set off, and write it into their logs.

    Args:
        robots: of `StandingObserver`.
        faults: as in the result: whose program failed stands for that reason.
        logs: folder with the robots' logs.
    """
    failed = {fault["robot"] for fault in faults}
    standing = [robot for robot in robots if robot not in failed]
    hints = [{"robots": standing, "remedy": _STANDS}] if standing else []
    _write_into_logs(hints, logs)
    return hints


def _write_into_logs(hints: Sequence[Mapping[str, Any]], logs: Path) -> None:
    for hint in hints:
        for robot in hint["robots"]:
            # A full disk is no reason to keep back the result of a match.
            with contextlib.suppress(OSError), (logs / f"{robot}.log").open("a", encoding="utf-8") as log:
                log.write(f"hint: {hint['remedy']}\n")


def _beginning(logs: Path, robot: str) -> str:
    """Return what a robot's log begins with: there a program asks for its devices."""
    try:
        with (logs / f"{robot}.log").open(encoding="utf-8", errors="replace") as log:
            return log.read(_BEGINNING)
    except OSError:
        return ""
