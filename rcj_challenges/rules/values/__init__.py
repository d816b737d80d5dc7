"""Values that rules name, one file each: what is remembered, measured, drawn, said by robots, or a fact of the match.

A value stands in the payload of an event and in the broadcast. Some are numbers, which are added up, counted and
compared; those of a sum have a weight.
"""

from collections.abc import Callable, Mapping
from typing import Annotated, Any

from pydantic import Field

from rcj_challenges.core.amounts import clamp_to_max, plain, round_score
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.rules.base import Firing, KeyedVocabulary, Number, Phrases, Reader, Scope, ValueWord
from rcj_challenges.rules.fields import LONGEST_S, DurationS, Scalar
from rcj_challenges.rules.phrasing import number, seconds
from rcj_challenges.rules.values.counter import CounterValue
from rcj_challenges.rules.values.distance import DistanceValue
from rcj_challenges.rules.values.draw import DrawnDuration, DrawValue, NumberDraw
from rcj_challenges.rules.values.flag import FlagValue
from rcj_challenges.rules.values.held import HeldValue
from rcj_challenges.rules.values.highest import HighestOfOthers
from rcj_challenges.rules.values.last_touch import LastTouchValue
from rcj_challenges.rules.values.lowest import LowestOfOthers
from rcj_challenges.rules.values.position_of import PositionValue
from rcj_challenges.rules.values.reported import ReportedValue
from rcj_challenges.rules.values.term import Term, Terms
from rcj_challenges.rules.values.timer import NumberTimer, TimerValue
from rcj_challenges.rules.values.way import WayValue
from rcj_challenges.rules.values.word import NumberWord, WordValue
from rcj_challenges.tracking.state import RefereeState

VALUES = KeyedVocabulary({"literal": Scalar}, lambda _value: "literal")
VALUES.add(
    CounterValue,
    FlagValue,
    DrawValue,
    WordValue,
    PositionValue,
    DistanceValue,
    WayValue,
    TimerValue,
    HeldValue,
    LastTouchValue,
    ReportedValue,
)
Value = Annotated[Scalar | ValueWord, VALUES]
"""What stands in the payload of an event or in the broadcast."""

TERMS = Terms(lambda: NUMBERS.words())  # noqa: PLW0108 - it is defined below
Part = Annotated[int | float | Term, TERMS]
"""A part of a sum."""
NUMBERS: KeyedVocabulary = KeyedVocabulary(
    {"number": int | float},
    lambda value: "parts" if isinstance(value, list | tuple) else "number",
    rest={"parts": Annotated[tuple[Part, ...], Field(strict=False)]},
)
NUMBERS.add(
    CounterValue,
    FlagValue,
    NumberDraw,
    NumberWord,
    DistanceValue,
    WayValue,
    NumberTimer,
    ReportedValue,
)
Points = Annotated[int | float | ValueWord | tuple[Part, ...], NUMBERS]
"""How many points are given, and how much is counted: a number, or a sum."""

BOUNDS = KeyedVocabulary({"number": int | float}, lambda _value: "number", otherwise="counter")
BOUNDS.add(CounterValue, LowestOfOthers, HighestOfOthers)
Bound = Annotated[int | float | ValueWord, BOUNDS]
"""What a condition compares with."""

DURATIONS = KeyedVocabulary({"number": DurationS}, lambda _value: "number", otherwise="draw")
DURATIONS.add(DrawnDuration, CounterValue)
Lasts = Annotated[float | DrawnDuration | CounterValue, DURATIONS]
"""How long something lasts: a timer, a phase, or what a rule does for a time."""


# --- what the referee makes of them -----------------------------------------------------------------------------------


def compile_value(value: Value, to: Scope) -> Reader:
    """Return a function that reads a value of an event's payload or of the broadcast."""
    return value.read(to) if isinstance(value, ValueWord) else lambda _firing: value


def compile_points(points: Points, to: Scope) -> Callable[[Firing], Number]:
    """Return a function that reads a number of points: one number, or a sum of numbers and terms."""
    if not isinstance(points, tuple):
        return _compile_number(points, to)
    parts = [(_compile_number(part, to), part.weight if isinstance(part, Term) else 1) for part in points]

    def total(firing: Firing) -> Number:
        summed: Number = 0
        for read, weight in parts:
            summed += clamp_to_max(read(firing) * weight)  # each part: ∞ - ∞ would be no number
        return round_score(summed)

    return total


def _compile_number(value: float | ValueWord, to: Scope) -> Callable[[Firing], Number]:
    if isinstance(value, ValueWord):
        return value.number(to)
    constant = plain(value)
    return lambda _firing: constant


def compile_bound(bound: Bound, to: Scope) -> Callable[[], Number]:
    """Return a function that reads what a condition compares with."""
    if isinstance(bound, ValueWord):
        return bound.now(to)
    constant = plain(bound)
    return lambda: constant


def longest_s(lasts_s: object, draws: Mapping[str, Any]) -> float | None:
    """Return the longest duration in s; None if it has no length, or a counter decides."""
    if isinstance(lasts_s, DrawnDuration):
        return max(float(value) for value in draws[lasts_s.draw].values)
    return lasts_s if isinstance(lasts_s, int | float) else None


def is_counted(lasts_s: Lasts) -> bool:
    """Return whether a counter says how long something lasts."""
    return isinstance(lasts_s, CounterValue)


def duration_s(lasts_s: Lasts, state: RefereeState, each: str | None, least_s: float = TICK_S) -> float:
    """Return a duration as its draw has decided or its counter stands by now."""
    match lasts_s:
        case DrawnDuration():
            return float(state.draws[lasts_s.draw])
        case CounterValue():
            whose = each if lasts_s.entity == "each" else lasts_s.entity
            # A counter may be anything: a duration that is too long must not end the match as a fault.
            return min(max(least_s, float(state.counter(lasts_s.counter, whose))), LONGEST_S)
    return float(lasts_s)


# --- what the sheet says of them --------------------------------------------------------------------------------------


def value_words(phrases: Phrases, value: Value) -> str:
    """Return a value of the scenario in words."""
    if isinstance(value, ValueWord):
        return value.describe(phrases)
    return str(value).lower() if isinstance(value, bool) else str(value)


def amount_words(phrases: Phrases, amount: Points | Bound) -> str:
    """Return points, counts or limits: a number, a counter, a sum: ``5, minus 0.1 times the time in full seconds``."""
    if isinstance(amount, ValueWord):
        return amount.describe_number(phrases)
    if not isinstance(amount, tuple):
        return number(amount)
    said = ""
    for part in amount:
        weight = part.weight if isinstance(part, Term) else part
        if said:
            said += ", minus " if weight < 0 else ", plus "
            weight = abs(weight)
        said += part.describe_times(phrases, weight) if isinstance(part, Term) else number(weight)
    return said


def duration_words(phrases: Phrases, lasts_s: Lasts) -> str:
    """Return a duration in words: ``15 s``, ``5 s or 8 s, as “pause” is drawn``, as many s as a counter says."""
    if isinstance(lasts_s, CounterValue):
        return f"as many s as {lasts_s.describe(phrases)} says"
    return lasts_s.describe(phrases) if isinstance(lasts_s, ValueWord) else seconds(lasts_s)
