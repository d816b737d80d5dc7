"""``referee.jsonl``: firings, events and changes, one JSON object a line, each with half and tick."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass
from itertools import groupby, product
from pathlib import Path
from types import NoneType
from typing import Any

from rcj_challenges.core.amounts import Score
from rcj_challenges.core.changes import Change, CountersChange, HeldChange, PhaseChange, ScoreChange
from rcj_challenges.core.play import Event, Firing
from rcj_challenges.records.folder import REFEREE_LOG, read_file
from rcj_challenges.records.lines import json_line, number_or_none, parsed
from rcj_challenges.records.reflog import event_line
from rcj_challenges.records.result import RunResult
from rcj_challenges.scenario.halves import teams_by_seat
from rcj_challenges.scenario.models.scenario import Scenario

Entry = Event | Firing | Change

_CHANGES: Mapping[type, str] = {
    PhaseChange: "phase",
    ScoreChange: "score",
    CountersChange: "counted",
    HeldChange: "held",
}
"""The kind of line that each change is written as."""

_MAX_NUMBER = 1e300
"""Of a measurement or score: Python's integers may be larger than any float."""


@dataclass(frozen=True)
class LoggedTick:
    """The entries of one tick in the log, as in the referee's `RefereeOutput`; faults are among the events."""

    half: int
    tick: int
    events: tuple[Event, ...] = ()
    firings: tuple[Firing, ...] = ()
    changes: tuple[Change, ...] = ()


@dataclass(frozen=True)
class RefereeLog:
    """A log, as far as it can be read: the ticks with at least one line, in order."""

    ticks: tuple[LoggedTick, ...] = ()
    damaged_lines: int = 0

    def up_to(self, ticks: Mapping[int, int]) -> RefereeLog:
        """Return the part up to a tick of each half; of other halves nothing."""
        kept = tuple(one for one in self.ticks if one.tick <= ticks.get(one.half, -1))
        return RefereeLog(kept, self.damaged_lines)

    def score(self, first: Mapping[str, Score], teams_in: Callable[[int], Mapping[str, str]]) -> dict[str, Score]:
        """Return the last score by team, also of a match that was killed; ``first`` is that of its beginning."""
        found = ((one.half, change) for one in reversed(self.ticks) for change in one.changes)
        half, last = next(((half, change) for half, change in found if isinstance(change, ScoreChange)), (0, None))
        if last is None:
            return dict(first)
        scores = {teams_in(half).get(seat, seat): points for seat, points in last.scores.items()}
        return dict(first) | {team: points for team, points in scores.items() if team in first}


def log_of_result(result: RunResult) -> RefereeLog:
    """Return the events of a result as a log, for a record that has lost it."""
    return RefereeLog(
        _by_tick([(one.half, one.tick, Event(one.tick, one.event, one.payload)) for one in result.events])
    )


def score_so_far(result: RunResult, scenario: Scenario, log: RefereeLog) -> dict[str, Score]:
    """Return the points of a run by team, also of one that was killed or is still played."""
    if result.complete or result.stopped is not None:
        return dict(result.score)
    return log.score(result.score, lambda half: teams_by_seat(scenario, half))


# --- writing ----------------------------------------------------------------------------------------------------------


def copies_of_rules(unresolved: Mapping[str, Any]) -> dict[str, tuple[str, str]]:
    """Return the name and the row of each copy of a repeated rule, by the copy's own name."""
    copies: dict[str, tuple[str, str]] = {}
    for name, rule in unresolved.get("rules", {}).items():
        tables = rule.get("repeat_for", ())
        if tables:
            rows = [unresolved["tables"][table] for table in ([tables] if isinstance(tables, str) else tables)]
            copies |= {f"{name}_{row}": (name, row) for row in map("_".join, product(*rows))}
    return copies


def log_lines(
    half: int,
    events: Iterable[Event],
    firings: Iterable[Firing],
    changes: Iterable[Change],
    copies: Mapping[str, tuple[str, str]],
) -> bytes:
    """Return the lines of one tick; ``copies`` is the result of `copies_of_rules`."""
    lines = [
        *(firing_line(half, firing, *copies.get(firing.rule, (firing.rule, ""))) for firing in firings),
        *({"kind": "event", **event_line(half, event)} for event in events),
        *({"half": half, "kind": _CHANGES[type(change)], **asdict(change)} for change in changes),
    ]
    return b"".join(map(json_line, lines))


def firing_line(half: int, firing: Firing, rule: str = "", copy: str = "") -> dict[str, Any]:
    """Return one firing as it stands in the log: by the name of its rule as it is written, and its row."""
    line: dict[str, Any] = {"half": half, "kind": "firing", **asdict(firing)}
    line |= {"rule": rule or firing.rule, "copy": copy or None}
    line["measured"] = number_or_none(firing.measured)
    line["limit"] = number_or_none(firing.limit)
    for key in ("other", "place", "copy"):
        if line[key] is None:
            del line[key]
    if settling := line.pop("settling"):
        line["pass"] = settling
    return line


# --- reading ----------------------------------------------------------------------------------------------------------


def read_referee_log(folder: Path) -> RefereeLog:
    """Read a log, as far as possible; a missing one is empty.

    Raises:
        RecordError: it is not a regular file, or too large.
    """
    entries: list[tuple[int, int, Entry]] = []
    damaged = 0
    for text in read_file(folder / REFEREE_LOG).splitlines() if (folder / REFEREE_LOG).exists() else ():
        try:
            line = parsed(text)
            entry = _entry(line)
            entries.append((_whole(line["half"], 1), entry.tick, entry))
        except (KeyError, TypeError, ValueError):
            damaged += 1
    return RefereeLog(_by_tick(entries), damaged)


def _by_tick(entries: Sequence[tuple[int, int, Entry]]) -> tuple[LoggedTick, ...]:
    ticks = []
    for (half, tick), group in groupby(entries, key=lambda one: one[:2]):
        found = [entry for _, _, entry in group]
        events = tuple(one for one in found if isinstance(one, Event))
        firings = tuple(one for one in found if isinstance(one, Firing))
        changes = tuple(one for one in found if not isinstance(one, Event | Firing))
        ticks.append(LoggedTick(half, tick, events, firings, changes))
    return tuple(ticks)


def _entry(line: Any) -> Entry:
    tick = _whole(line["tick"], 0)
    match line["kind"]:
        case "event":
            return Event(tick, _typed(line["event"], str), _typed(line["payload"], dict))
        case "firing":
            copy = _typed(line.get("copy", ""), str)
            return Firing(
                tick=tick,
                rule=f"{_typed(line['rule'], str)}_{copy}" if copy else _typed(line["rule"], str),
                entity=_typed(line.get("entity"), str, NoneType),
                trigger=_typed(line["trigger"], str),
                measured=_number_or_none(line.get("measured")),
                limit=_number_or_none(line.get("limit")),
                scored=_points(line["scored"]),
                suppressed=_typed(line.get("suppressed"), str, NoneType),
                says=_typed(line.get("says", ""), str),
                other=_typed(line.get("other"), str, NoneType),
                place=_typed(line.get("place"), str, NoneType),
                settling=_whole(line.get("pass", 0), 0),
                copy=copy,
            )
        case "phase":
            return PhaseChange(tick, _typed(line["phase"], str), bool(line["waiting_for_kickoff"]))
        case "score":
            return ScoreChange(tick, _points(line["scores"]))
        case "counted":
            return CountersChange(
                tick, {name: _counter(value) for name, value in _typed(line["counters"], dict).items()}
            )
        case "held":
            return HeldChange(tick, tuple(_typed(robot, str) for robot in line["robots"]))
    raise ValueError("a line of another kind")


def _whole(value: Any, least: int) -> int:
    if type(value) is not int or value < least:
        raise TypeError("not a whole number")
    return value


def _typed(value: Any, *kinds: type) -> Any:
    """Return a value of one of these kinds; raise TypeError for another."""
    if not isinstance(value, kinds):
        raise TypeError("a value of another kind")
    return value


def _number_or_none(value: Any) -> float | None:
    if value is not None and not (isinstance(value, int | float) and abs(value) <= _MAX_NUMBER):
        raise TypeError("not a number")
    return value


def _counter(value: Any) -> Score | dict[str, Score | None] | None:
    if isinstance(value, dict):
        return {entity: _number_or_none(number) for entity, number in value.items()}
    return _number_or_none(value)


def _points(value: Any) -> dict[str, Score]:
    points = {seat: _number_or_none(number) for seat, number in _typed(value, dict).items()}
    return {seat: number for seat, number in points.items() if number is not None}
