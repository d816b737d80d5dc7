"""Values by which entrants are ranked: a value that is a number, and what is better."""

from collections.abc import Sequence
from math import inf
from typing import Annotated, Any, ClassVar, Literal

from rcj_challenges.core.amounts import add_up, round_score
from rcj_challenges.rules.base import KeyedVocabulary, KeyedWord, Number, Reader, Scope
from rcj_challenges.rules.fields import described
from rcj_challenges.rules.number import Amount, NumberValue, Valued, by_key, with_keys_of
from rcj_challenges.rules.values import NUMBERS, compile_amount
from rcj_challenges.rules.values.counter import CounterValue
from rcj_challenges.rules.values.draw import DrawValue
from rcj_challenges.rules.values.folded import FoldedValue
from rcj_challenges.rules.values.kept import KeptValue
from rcj_challenges.rules.values.score import ScoreValue
from rcj_challenges.rules.values.word import WordValue

_SCORE = ScoreValue.model_construct(score="each")


class Ranked(Valued, KeyedWord):
    """What stands beside a value by which entrants are ranked; it is read for each of them when a half has settled.

    A score, or a counter that is kept for the match, counts with what each half adds to it, but for ``over: last``. A
    half without a value is worse than all others.

    Attributes:
        IS_PART: that the schema defines these fields once for all such values.
    """

    IS_PART: ClassVar = True

    better: Literal["more", "less"] = described(..., "more: the higher value is better; less: the lower one")
    over: Literal["sum", "best", "worst", "last"] = described(
        "sum", "of the halves: their sum, the best one, the worst one; last: what it is when the match is over"
    )
    says: str | None = described(
        None,
        "the sentence for players on the rule sheet, required except for {score: each}; params by name are filled in",
        max_length=500,
    )

    @property
    def names(self) -> list[str]:
        """The names of all that it is made of: ``[time_s, touched_posts]``."""
        return list(dict.fromkeys(map(_name_of, _measures_in(self.value))))

    @property
    def is_score(self) -> bool:
        """Whether it is nothing but the score."""
        return self.value == _SCORE and self.over in ("sum", "last")

    @property
    def is_time(self) -> bool:
        """Whether it is a time that should be short."""
        return isinstance(value := self.value, WordValue) and value.word == "time_s" and self.better == "less"

    def compile(self, to: Scope) -> Reader:
        """Return a function that reads it as the scope's ``each`` counts; None: there is none."""
        return compile_amount(self.value, to)

    def number(self, value: Number | None) -> Number:
        """Return a number that is the greater the worse the value is; none is worse than all."""
        return inf if value is None else value if self.better == "less" else -value

    def value_of(self, number: Number) -> Number | None:
        """Return the value of such a number, or of the sum of several."""
        return None if number == inf else round_score(number if self.better == "less" else -number)

    def of_halves(self, values: Sequence[Number | None]) -> Number | None:
        """Return what counts of the values of the halves."""
        if self.over == "sum":
            known = [value for value in values if value is not None]
            return round_score(add_up(known)) if len(known) == len(values) else None
        if self.over == "last":
            return values[-1] if values else None
        return (min if self.over == "best" else max)(values, key=self.number, default=None)


_WORDS = {
    value.KEY: with_keys_of(value, Ranked, "Ranks") for value in NUMBERS.words() if issubclass(value, NumberValue)
}
for word in _WORDS.values():
    asked = tuple((*keys, "says") for keys in word.VALUE.REQUIRES or ((),))
    word.REQUIRES = () if word.VALUE is ScoreValue else asked
RANKED = KeyedVocabulary({}, lambda _value: None)
RANKED.add(*_WORDS.values())
AnyRanked = Annotated[Ranked, RANKED]


def _ranked(value: NumberValue, **beside: Any) -> Ranked:
    return _WORDS[value.KEY].model_construct(**by_key(value, type(value)), **beside)


BY_SCORE = _ranked(_SCORE, better="more")


def counters_in(rank: Sequence[Ranked]) -> dict[str, Ranked]:
    """Return what is counted for a ranking, by the name of the counter, without what stands beside it."""
    found: dict[str, Ranked] = {}
    for ranked in rank:
        for measure in _measures_in(ranked.value):
            if isinstance(inner := _inner(measure), CounterValue):
                found.setdefault(inner.counter, _ranked(measure, better=ranked.better, over=ranked.over))
    return found


def _measures_in(amount: Amount | None) -> list[NumberValue]:
    """Return the values of which a number is made, each without what stands beside it."""
    if not isinstance(amount, NumberValue):
        return []
    several = amount.several() if isinstance(amount, FoldedValue) else ()
    own = [one for part in several for one in _measures_in(part)] if isinstance(several, tuple) else []
    beside = (amount.otherwise, amount.times, amount.plus, amount.minus)
    return [*(own or [amount.alone()]), *(one for part in beside for one in _measures_in(part))]


def _name_of(measure: NumberValue) -> str:
    """Return the name of a measure, with its unit if it has one: ``time_s``, ``touched_posts``, ``distance_m``."""
    inner = _inner(measure)
    is_named = isinstance(inner, KeptValue | WordValue | DrawValue)
    name, unit = str(getattr(inner, inner.KEY)) if is_named else inner.KEY, _UNITS.get(inner.UNIT, "")
    return name if name.endswith(unit) else name + unit


_UNITS = {"m": "_m", "m/s": "_mps", "s": "_s"}


def _inner(measure: NumberValue) -> NumberValue:
    """Return what is read of each of several."""
    several = measure.several() if isinstance(measure, FoldedValue) else measure
    return measure if isinstance(several, tuple) else several
