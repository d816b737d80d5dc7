"""Values that rules name, one file each: what is remembered, measured, drawn, said by robots, or a fact of the match.

A value stands in the payload of an event and in the broadcast. Most are numbers, which may stand wherever a rule has a
number.
"""

from collections.abc import Callable, Mapping
from typing import Annotated, Any

from pydantic import Field

from rcj_challenges.rules.base import Binder, Firing, KeyedVocabulary, Phrases, Reader, Scope, ValueWord
from rcj_challenges.rules.fields import LONGEST_S, DurationS, NotNegative, Positive, Scalar
from rcj_challenges.rules.number import NUMBERS, Amount, NumberValue, amount_words, compile_amount
from rcj_challenges.rules.phrasing import seconds, spelled
from rcj_challenges.rules.values.count import CountValue
from rcj_challenges.rules.values.counter import CounterValue
from rcj_challenges.rules.values.distance import DistanceValue
from rcj_challenges.rules.values.draw import DrawnDuration, DrawValue, NumberDraw
from rcj_challenges.rules.values.entity import FactValue
from rcj_challenges.rules.values.flag import FlagValue
from rcj_challenges.rules.values.folded import FoldedValue
from rcj_challenges.rules.values.highest import HighestValue
from rcj_challenges.rules.values.last_touch import LastTouchValue
from rcj_challenges.rules.values.lowest import LowestValue
from rcj_challenges.rules.values.position_of import PositionValue
from rcj_challenges.rules.values.reported import ReportedValue
from rcj_challenges.rules.values.role import RoleValue
from rcj_challenges.rules.values.score import ScoreValue
from rcj_challenges.rules.values.speed import SpeedValue
from rcj_challenges.rules.values.sum import SumValue
from rcj_challenges.rules.values.timer import TimerValue
from rcj_challenges.rules.values.way import WayValue
from rcj_challenges.rules.values.word import NumberWord, WordValue

_NUMBERS = (
    CountValue,  # first: the keys of its facts are words too
    CounterValue,
    FlagValue,
    DistanceValue,
    SpeedValue,
    WayValue,
    TimerValue,
    ScoreValue,
    ReportedValue,
    HighestValue,
    LowestValue,
    SumValue,
)
COMPARABLE = (*(word for word in _NUMBERS if word is not ReportedValue), NumberWord)
"""Values whose comparison has nothing of its own."""
NUMBERS.add(*_NUMBERS, NumberDraw, NumberWord, FactValue)  # the last one: its key stands beside those of others

VALUES = KeyedVocabulary({"literal": Scalar}, lambda _value: "literal")
VALUES.add(*_NUMBERS, DrawValue, RoleValue, WordValue, PositionValue, LastTouchValue, FactValue)
Value = Annotated[Scalar | ValueWord, VALUES]
"""What stands in the payload of an event or in the broadcast."""

FOLDS = frozenset(word.KEY for word in _NUMBERS if issubclass(word, FoldedValue))
"""Keys below which a value may name a group, of each of which it is read."""

DURATIONS = NUMBERS.beside({"number": DurationS}, lambda _value: "number", DrawnDuration)
Lasts = Annotated[float | ValueWord, DURATIONS]
"""How long something lasts: a timer, a phase, or what a rule does for a time."""
Limit = Annotated[float | ValueWord, NUMBERS.beside({"number": Positive}, lambda _value: "number")]
"""A length that a trigger measures against."""
Angle = Annotated[
    float | ValueWord, NUMBERS.beside({"number": Annotated[float, Field(gt=0, lt=3.1416)]}, lambda _value: "number")
]
"""An angle that a trigger measures against, in rad."""
Waits = Annotated[float | ValueWord, NUMBERS.beside({"number": NotNegative}, lambda _value: "number")]
"""How long a trigger waits, or overlooks something: also not at all."""


# --- what the referee makes of them -----------------------------------------------------------------------------------


def compile_value(value: Value, to: Scope) -> Reader:
    """Return a function that reads a value of an event's payload or of the broadcast."""
    if isinstance(value, ValueWord):
        return to.by_role(value, lambda one: one.read(to), None)
    return lambda _firing: value


def longest_s(lasts_s: object, draws: Mapping[str, Any]) -> float | None:
    """Return the longest duration in s; None if it has no length, or is calculated when it begins."""
    if isinstance(lasts_s, DrawnDuration) and not lasts_s.is_computed():
        return max(float(value) for value in draws[lasts_s.draw].values)
    return lasts_s if isinstance(lasts_s, int | float) else None


def is_calculated(lasts_s: Lasts) -> bool:
    """Return whether it is known only when it begins how long something lasts."""
    return isinstance(lasts_s, ValueWord) and not (isinstance(lasts_s, DrawnDuration) and not lasts_s.is_computed())


def compile_duration(
    lasts_s: Amount, to: Scope, least: float = 0.0, most: float = LONGEST_S
) -> Callable[[Firing], float | None]:
    """Return a function that reads a duration in s, or another limit; None: there is none."""
    read = compile_amount(lasts_s, to)

    def limited(firing: Firing) -> float | None:
        value = read(firing)
        # A value may be anything: a duration that is too long must not end the match as a fault.
        return None if value is None else min(max(least, float(value)), most)

    return limited


def compile_limit(
    limit: Amount, to: Binder, least: float = 0.0, most: float = LONGEST_S, none: float = LONGEST_S
) -> Callable[[], float]:
    """Return a function that reads a limit as its measuring begins; ``none``: what stands for no such number."""
    if isinstance(limit, int | float):
        return lambda: limit
    read, firing = compile_duration(limit, to, least, most), Firing(to.rule, None, "")

    def limit_now() -> float:
        value = read(firing)
        return none if value is None else value

    return limit_now


# --- what the sheet says of them --------------------------------------------------------------------------------------


def value_words(phrases: Phrases, value: Value) -> str:
    """Return a value of the scenario in words."""
    if isinstance(value, NumberValue) and value.is_computed():
        return amount_words(phrases, value)
    if isinstance(value, ValueWord):
        return value.describe(phrases)
    return spelled(value)


def duration_words(phrases: Phrases, lasts_s: Lasts) -> str:
    """Return a duration in words: ``15 s``, ``5 s or 8 s, as “pause” is drawn``, as many s as a counter says."""
    if isinstance(lasts_s, ValueWord) and not is_calculated(lasts_s):
        return lasts_s.describe(phrases)
    return limit_words(phrases, lasts_s, seconds, "s")


def every_words(phrases: Phrases, every_s: Lasts) -> str:
    """Return how often something comes again: ``every 5 s``, ``each time after as many s as a counter says``."""
    words = duration_words(phrases, every_s)
    return f"each time after {words}" if is_calculated(every_s) else f"every {words}"


def limit_words(phrases: Phrases, limit: Amount, written: Callable[[float], str], unit: str) -> str:
    """Return a limit in words: as it is written, or ``as many m as the counter “budget” says``."""
    if isinstance(limit, int | float):
        return written(limit)
    is_plain = isinstance(limit, CounterValue | NumberDraw) and not limit.is_computed()
    return f"as many {unit} as {amount_words(phrases, limit)}{' says' * is_plain}"


__all__ = (
    "COMPARABLE", "DURATIONS", "FOLDS", "NUMBERS", "VALUES", "Amount", "Angle", "Lasts", "Limit", "Value", "Waits",
    "amount_words", "compile_amount", "compile_duration", "compile_limit", "compile_value", "duration_words",
    "every_words", "is_calculated", "limit_words", "longest_s", "value_words",
)  # fmt: skip
