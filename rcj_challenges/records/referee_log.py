"""Reading ``referee.jsonl``: events, firings, phases, who is held and what was counted, as far as it can be read."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

from rcj_challenges.facts.amounts import Score, counted, round_score
from rcj_challenges.records.folder import REFEREE_LOG, read_file
from rcj_challenges.records.lines import parsed
from rcj_challenges.records.result import RunResult
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.seats import teams_by_seat

_PLACE: dict[str, type] = {"half": int, "tick": int}
_NEEDED: dict[str, dict[str, type]] = {
    "firing": {"rule": str, "trigger": str, "scored": dict},
    "event": {"event": str, "payload": dict},
    "phase": {"phase": str, "waiting_for_kickoff": bool},
    "held": {"robots": list},
    "counted": {"counters": dict},
}
"""What a line of each kind must have, and what that must be."""


def read_referee_log(folder: Path) -> tuple[list[dict[str, Any]], int]:
    """Return the lines that can be read, in order, and how many cannot; a log that is not there has none.

    Raises:
        RecordError: it is no file.
    """
    path = folder / REFEREE_LOG
    lines: list[dict[str, Any]] = []
    unreadable = 0
    for text in read_file(path).splitlines() if path.exists() else ():
        line = _line(text)
        if line is None:
            unreadable += 1
        else:
            lines.append(line)
    return lines, unreadable


def damaged_lines(unreadable: int) -> str:
    """Return in words how many lines of a log are damaged, without a full stop."""
    return f"{counted(unreadable, 'line')} of the referee's log {'is' if unreadable == 1 else 'are'} damaged"


def events_as_lines(result: RunResult) -> list[dict[str, Any]]:
    """Return the events of a result as lines of the log, for a record that has lost it."""
    return [{"kind": "event", **event.model_dump()} for event in result.events]


def points_in(
    lines: Iterable[dict[str, Any]], teams: Iterable[str], teams_in: Callable[[int], Mapping[str, str]]
) -> dict[str, Score]:
    """Return the points by team that rules gave in these lines.

    ``result.json`` tells points when a half is over: of a match that was killed, or goes on, the log knows more.

    Args:
        lines: of the log.
        teams: of the match.
        teams_in: returns, for a half (1-based), the team that plays at each seat.
    """
    points: dict[str, Score] = dict.fromkeys(teams, 0)
    for line in lines:
        for seat, scored in () if line.get("suppressed") else line.get("scored", {}).items():
            team = teams_in(line["half"]).get(seat, seat)
            if team in points:  # in a damaged log any name may stand
                points[team] = round_score(points[team] + scored)
    return points


def points_so_far(result: RunResult, scenario: Scenario, lines: list[dict[str, Any]]) -> Mapping[str, Score]:
    """Return the points of a run by team, also of one that was killed or goes on; ``lines`` are those of its log."""
    if result.complete or result.stopped is not None or not lines:
        return result.score
    return points_in(lines, result.score, lambda half: teams_by_seat(scenario, half))


def _line(text: bytes) -> dict[str, Any] | None:
    try:
        line = parsed(text)
    except ValueError:
        return None
    if not isinstance(line, dict) or not isinstance(line.get("kind"), str):
        return None
    needed = _NEEDED.get(line["kind"])
    if needed is None or not all(isinstance(line.get(key), kind) for key, kind in (_PLACE | needed).items()):
        return None
    scored = line.get("scored", {})
    numbers = all(isinstance(points, int | float) and abs(points) < math.inf for points in scored.values())
    return line if numbers else None
