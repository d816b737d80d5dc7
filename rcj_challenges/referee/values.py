"""Values that rules can name: literals, counters, flags, draws, words of the match, positions; and points."""

from __future__ import annotations

from collections.abc import Callable
from math import floor
from typing import Any

from rcj_challenges.facts.amounts import on_paper, plain
from rcj_challenges.facts.timing import s_from_ticks
from rcj_challenges.referee.compiling import Workshop
from rcj_challenges.referee.rules import Occasion
from rcj_challenges.referee.state import Number, State
from rcj_challenges.scenario.models.state import (
    CounterValue,
    DrawValue,
    FlagValue,
    NumberWord,
    PositionValue,
    WordValue,
)

Reader = Callable[[Occasion], Any]
"""Reads a value at the moment of a firing; JSON-able."""


def compile_value(value: Any, workshop: Workshop, each: str | None) -> Reader:
    """Return the reader of a value of an event's payload or of the broadcast."""
    state = workshop.state
    match value:
        case CounterValue():
            counter = counter_reader(value, workshop, each)
            return lambda _occasion: counter()
        case FlagValue():
            flag, flag_of = value.flag, workshop.whose(value.entity, each)
            return lambda _occasion: state.flag(flag, flag_of)
        case DrawValue():
            draw = value.draw
            return lambda _occasion: state.draws[draw]
        case WordValue():
            read, of = WORDS[value.word], value.of
            return lambda occasion: read(state, occasion, of)
        case PositionValue():
            entity = workshop.entity(value.position_of, each)
            return lambda _occasion: _position(state, entity)
        case _:
            return lambda _occasion: value


def counter_reader(value: CounterValue, workshop: Workshop, each: str | None) -> Callable[[], Number]:
    """Return what reads a counter, or an entrant's score."""
    state, name, whose = workshop.state, value.counter, workshop.whose(value.entity, each)
    return lambda: state.counter(name, whose)


def compile_bound(bound: Number | CounterValue, workshop: Workshop, each: str | None) -> Callable[[], Number]:
    """Return what reads a number or a counter to compare with."""
    if isinstance(bound, CounterValue):
        return counter_reader(bound, workshop, each)
    number = plain(bound)
    return lambda: number


def compile_amount(amount: Any, workshop: Workshop, each: str | None) -> Callable[[Occasion], Number]:
    """Return what reads a number, a counter, a flag (1 if it is set, else 0), a draw or a number of the match."""
    if not isinstance(amount, CounterValue | FlagValue | DrawValue | NumberWord):
        number = plain(amount)
        return lambda _occasion: number
    read = compile_value(amount, workshop, each)
    if isinstance(amount, NumberWord):
        as_number = floor if amount.word in _TIMES else _or_zero
        return lambda occasion: as_number(read(occasion))
    if isinstance(amount, FlagValue):
        return lambda occasion: int(read(occasion))
    return read


def compile_points(points: Any, workshop: Workshop, each: str | None) -> Callable[[Occasion], Number]:
    """Return what reads a number of points: one amount, or the sum of weighted ones."""
    if not isinstance(points, tuple):
        return compile_amount(points, workshop, each)
    parts = [(compile_amount(part, workshop, each), part.weight) for part in points]

    def total(occasion: Occasion) -> Number:
        summed: Number = 0
        for read, weight in parts:
            summed += read(occasion) * weight
        return on_paper(summed)

    return total


def _or_zero(number: Number | None) -> Number:
    return 0 if number is None else number


def _position(state: State, entity: int) -> list[float] | None:
    """Return [x, y, yaw]; rounded to the micrometre, finer than float32 poses are anyway."""
    return [round(number, 6) for number in state.poses[entity]] if state.present[entity] else None


def _entrant(state: State, occasion: Occasion, of: str | None) -> str:
    """Return the entrant meant: the named one, else that of the robot that the firing is about."""
    if of is not None:
        return of
    owners = (state.entrant_of.get(name) for name in (occasion.rule.each, occasion.entity) if name is not None)
    return next((owner for owner in owners if owner is not None), "")


def _robot_name(state: State, occasion: Occasion, _of: str | None) -> str:
    names = (name for name in (occasion.rule.each, occasion.entity) if name in state.scenario.robots)
    return next((name for name in names if name is not None), "")


def _team_name(state: State, occasion: Occasion, of: str | None) -> str:
    entrant = _entrant(state, occasion, of)
    return state.half.team_names.get(entrant, entrant)


def _score(state: State, occasion: Occasion, of: str | None) -> Number:
    return state.scores.get(_entrant(state, occasion, of), 0)


WORDS: dict[str, Callable[[State, Occasion, str | None], Any]] = {
    "robot_name": _robot_name,
    "entity_name": lambda _state, occasion, _of: occasion.subject or "",
    "team_name": _team_name,
    "entrant": _entrant,
    "score": _score,
    "halftime": lambda state, _occasion, _of: state.half.half,
    "match_id": lambda state, _occasion, _of: state.half.match_id,
    "total_match_time_s": lambda state, _occasion, _of: state.half_length_s(),
    "time_s": lambda state, _occasion, _of: s_from_ticks(state.clock),
    "time_left_s": lambda state, _occasion, _of: s_from_ticks(max(0, state.half.ticks - state.clock)),
    "measured": lambda _state, occasion, _of: _rounded(occasion.measured),
    "limit": lambda _state, occasion, _of: _rounded(occasion.limit),
    "phase": lambda state, _occasion, _of: state.phase,
    "seed_id": lambda state, _occasion, _of: state.seed_id(),
}
"""The words of `WordValue`, each with what it reads."""

_TIMES = frozenset({"total_match_time_s", "time_s", "time_left_s"})
"""Words whose whole seconds count."""


def _rounded(number: float | None) -> Number | None:
    return None if number is None else plain(round(number, 6))


def spoken(says: str, state: State, occasion: Occasion) -> str:
    """Return the sentence with {entity}, {team}, {measured} and {limit} filled in; anything else stays as written."""
    if "{" not in says:
        return says
    filled = {
        "{entity}": occasion.subject or "",
        "{team}": _team_name(state, occasion, None),
        "{measured}": _said(occasion.measured),
        "{limit}": _said(occasion.limit),
    }
    # One pass from left to right, so that a team called "{limit}" stays just that.
    parts, rest = [], says
    while rest:
        places = [(rest.find(key), key) for key in filled if key in rest]
        if not places:
            break
        start, key = min(places)
        parts += [rest[:start], filled[key]]
        rest = rest[start + len(key) :]
    return "".join([*parts, rest])


def _said(number: float | None) -> str:
    return "" if number is None else f"{round(number, 3):g}"
