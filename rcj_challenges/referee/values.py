"""Values that rules can name: literals, what is remembered, measured or a word of the match; points; sentences."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from math import floor, nan
from typing import Any

from rcj_challenges.facts.amounts import plain, round_score, within_most
from rcj_challenges.facts.messages import number_in
from rcj_challenges.facts.timing import s_from_ticks
from rcj_challenges.referee.compiling import CompileContext
from rcj_challenges.referee.measuring import distance_reader, timer_reader, way_reader
from rcj_challenges.referee.state import State
from rcj_challenges.rules.values import (
    CounterValue,
    DistanceValue,
    DrawValue,
    FlagValue,
    HeldValue,
    HighestOfOthers,
    LastTouchValue,
    LowestOfOthers,
    NumberTimer,
    NumberTold,
    NumberWord,
    PositionValue,
    TimerValue,
    ToldValue,
    WayValue,
    WordValue,
)
from rcj_challenges.scenario.blanks import counted
from rcj_challenges.scenario.measured import middle_of
from rcj_challenges.tracking.bound_rules import Firing
from rcj_challenges.tracking.state import Number

Reader = Callable[[Firing], Any]
"""Reads a value at the moment of a firing; JSON-able."""


def compile_value(value: Any, context: CompileContext, each: str | None) -> Reader:
    """Return the reader of a value of an event's payload or of the broadcast."""
    state = context.state
    read_now = _reader_of_now(value, context, each)
    if read_now is not None:
        return lambda _firing: read_now()
    match value:
        case FlagValue():
            flag, flag_of = value.flag, context.whose(value.entity, each)
            return lambda _firing: state.flag(flag, flag_of)
        case DrawValue():
            draw = value.draw
            return lambda _firing: state.draws[draw]
        case WordValue():
            read, of = WORDS[value.word], value.of
            return lambda firing: read(state, firing, of)
        case PositionValue():
            return _position_reader(value, context, each)
        case _:
            return lambda _firing: value


def _reader_of_now(value: Any, context: CompileContext, each: str | None) -> Callable[[], Any] | None:
    """Return the reader of a value that is the same whichever rule fires; None for any other."""
    makers = (make for kind, make in _READERS_OF_NOW.items() if isinstance(value, kind))
    make = next(makers, None)
    return None if make is None else make(value, context, each)


def _position_reader(value: PositionValue, context: CompileContext, each: str | None) -> Reader:
    state, name = context.state, value.position_of
    if name in context.roster.drawn:
        positions = {one: PositionValue(position_of=one) for one in context.roster.drawn[name]}
        readers = {one: _position_reader(position, context, None) for one, position in positions.items()}

        def decided(firing: Firing) -> Any:
            return readers[str(state.draws[name])](firing)

        return decided
    if name in state.spots:
        return lambda _firing: [round(number, 6) for number in state.spots[name]]
    thing = context.thing(name, each)
    if thing >= len(context.roster.entities):
        standing = middle_of(context.scenario.obstacles[context.roster.things[thing]])
        return lambda _firing: [round(number, 6) for number in standing]
    return lambda _firing: _position(state, thing)


def _last_toucher(value: LastTouchValue, context: CompileContext, each: str | None) -> Callable[[], str | None]:
    """Return what tells the name of the robot that touched something last; None if none has."""
    contacts, touched = context.contacts, context.thing(value.last_touch, each)
    contacts.follow_last(touched)

    def read() -> str | None:
        robot = contacts.last(touched)
        return None if robot is None else context.roster.entities[robot]

    return read


def _heard(value: ToldValue, context: CompileContext, each: str | None) -> Callable[[], str | Number | None]:
    """Return what tells what a robot has told the referee last; where a number is counted, 0 if it was none."""
    told, robot = context.state.heard, context.members(value.told, each)[0]
    if isinstance(value, NumberTold):
        return lambda: round_score(number_in(told.get(robot, "")) or 0)
    return lambda: told.get(robot)


def _whether_held(value: HeldValue, context: CompileContext, each: str | None) -> Callable[[], bool]:
    """Return what tells whether a robot is held."""
    return partial(context.state.held.holds, context.entity(value.held, each))


def counter_reader(value: CounterValue, context: CompileContext, each: str | None) -> Callable[[], Number]:
    """Return what reads a counter, or an entrant's score."""
    state, name, whose = context.state, value.counter, context.whose(value.entity, each)
    return lambda: state.counter(name, whose)


_READERS_OF_NOW: dict[type, Callable[[Any, CompileContext, str | None], Callable[[], Any]]] = {
    CounterValue: counter_reader,
    DistanceValue: distance_reader,
    WayValue: way_reader,
    TimerValue: timer_reader,
    LastTouchValue: _last_toucher,
    ToldValue: _heard,
    HeldValue: _whether_held,
}

Bound = Number | CounterValue | LowestOfOthers | HighestOfOthers
"""What is compared with, as the scenario's models have it."""


def compile_bound(bound: Bound, context: CompileContext, each: str | None) -> Callable[[], Number]:
    """Return what reads what is compared with: a number, a counter, or the lowest or highest of others."""
    match bound:
        case CounterValue():
            return counter_reader(bound, context, each)
        case LowestOfOthers():
            return _of_others(min, bound.lowest, context, each)
        case HighestOfOthers():
            return _of_others(max, bound.highest, context, each)
    number = plain(bound)
    return lambda: number


def _of_others(
    pick: Callable[[list[Number]], Number], name: str, context: CompileContext, each: str | None
) -> Callable[[], Number]:
    """Return what reads the lowest or highest value of a counter but that of ``each``.

    It is not a number, with which nothing compares, where nobody else is on the field, or ``each`` is not.
    """
    state, entities = context.state, context.roster.entities
    index = {entity: number for number, entity in enumerate(entities)}

    def is_there(member: str) -> bool:
        return member not in index or state.present[index[member]]  # zones and gates always are

    def read() -> Number:
        kept = state.counters[name]
        if not isinstance(kept, dict) or (each is not None and not is_there(each)):
            return nan
        values = [value for member, value in kept.items() if member != each and is_there(member)]
        return pick(values) if values else nan

    return read


def compile_amount(amount: Any, context: CompileContext, each: str | None) -> Callable[[Firing], Number]:
    """Return what reads a number, a counter, a flag (1 if it is set, else 0), a draw, or a number of the match."""
    if isinstance(amount, int | float):
        number = plain(amount)
        return lambda _firing: number
    read = compile_value(amount, context, each)
    counted = _counted(amount)
    return read if counted is None else lambda firing: counted(read(firing))


def _counted(amount: Any) -> Callable[[Any], Number] | None:
    """Return what makes a number to be counted of what is told; None if it is one."""
    if isinstance(amount, NumberTimer) or (isinstance(amount, NumberWord) and amount.word in _TIMES):
        return None if amount.fraction else floor
    if isinstance(amount, FlagValue):
        return int
    return _or_zero if isinstance(amount, NumberWord | DistanceValue) else None


def compile_points(points: Any, context: CompileContext, each: str | None) -> Callable[[Firing], Number]:
    """Return what reads a number of points: one amount, or the sum of numbers and weighted ones."""
    if not isinstance(points, tuple):
        return compile_amount(points, context, each)
    parts = [(compile_amount(part, context, each), getattr(part, "weight", 1)) for part in points]

    def total(firing: Firing) -> Number:
        summed: Number = 0
        for read, weight in parts:
            summed += within_most(read(firing) * weight)  # each part: of ∞ - ∞ nothing could be told
        return round_score(summed)

    return total


def _or_zero(number: Number | None) -> Number:
    return 0 if number is None else number


def _position(state: State, entity: int) -> list[float] | None:
    """Return [x, y, yaw]; rounded to the micrometre, finer than float32 poses are anyway."""
    return [round(number, 6) for number in state.poses[entity]] if state.present[entity] else None


def _entrant(state: State, firing: Firing, of: str | None) -> str:
    """Return the entrant meant: the named one, else that of the robot that the firing is about."""
    if of is not None:
        return of
    owners = (state.entrant_of.get(name) for name in (firing.rule.each, firing.entity) if name is not None)
    return next((owner for owner in owners if owner is not None), "")


def _robot_name(state: State, firing: Firing, _of: str | None) -> str:
    names = (name for name in (firing.rule.each, firing.entity) if name in state.scenario.robots)
    return next((name for name in names if name is not None), "")


def _team_name(state: State, firing: Firing, of: str | None) -> str:
    entrant = _entrant(state, firing, of)
    return state.half.team_names.get(entrant, entrant)


def _score(state: State, firing: Firing, of: str | None) -> Number:
    return state.scores.get(_entrant(state, firing, of), 0)


WORDS: dict[str, Callable[[State, Firing, str | None], Any]] = {
    "robot_name": _robot_name,
    "entity_name": lambda _state, firing, _of: firing.subject or "",
    "each_name": lambda _state, firing, _of: firing.rule.each or "",
    "other_name": lambda _state, firing, _of: firing.rule.other or "",
    "team_name": _team_name,
    "entrant": _entrant,
    "score": _score,
    "halftime": lambda state, _firing, _of: state.half.half,
    "match_id": lambda state, _firing, _of: state.half.match_id,
    "total_match_time_s": lambda state, _firing, _of: state.half_length_s(),
    "time_s": lambda state, _firing, _of: s_from_ticks(state.clock),
    "time_left_s": lambda state, _firing, _of: s_from_ticks(max(0, state.half.ticks - state.clock)),
    "measured": lambda _state, firing, _of: _rounded(firing.measured),
    "limit": lambda _state, firing, _of: _rounded(firing.limit),
    "phase": lambda state, _firing, _of: state.phase,
    "seed_id": lambda state, _firing, _of: state.seed_id(),
}
"""The words of `WordValue`, each with what it reads."""

_TIMES = frozenset({"total_match_time_s", "time_s", "time_left_s"})
"""Words whose whole seconds count."""


def _rounded(number: float | None) -> Number | None:
    return None if number is None else plain(round(number, 6))


def spoken(says: str, state: State, firing: Firing) -> str:
    """Return the sentence with {entity}, {each}, {other}, {team}, {measured}, {limit} and {points} filled in."""
    if "{" not in says:
        return says
    points = str(round_score(sum(firing.scored.values())))
    filled = {
        "{entity}": _named(firing.subject),
        "{each}": _named(firing.rule.each),
        "{other}": _named(firing.rule.other),
        "{team}": _team_name(state, firing, None),
        "{measured}": _said(firing.measured),
        "{limit}": _said(firing.limit),
        "{points}": points,
        "{points} points": counted(points),
    }
    # One pass from left to right, so that a team called "{limit}" stays just that.
    parts, rest = [], says
    while rest:
        places = [(rest.find(key), -len(key), key) for key in filled if key in rest]
        if not places:
            break
        start, _, key = min(places)
        parts += [rest[:start], filled[key]]
        rest = rest[start + len(key) :]
    return "".join([*parts, rest])


def _named(name: str | None) -> str:
    """Return a name as people write it, as the rule sheet does: ``blue goal``."""
    return (name or "").replace("_", " ")


def _said(number: float | None) -> str:
    return "" if number is None else f"{round(number, 3):g}"
