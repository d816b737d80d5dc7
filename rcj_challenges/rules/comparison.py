"""Comparing what is measured or counted with numbers."""

from collections.abc import Callable
from operator import eq, ge, gt, le, lt
from typing import ClassVar, NamedTuple

from rcj_challenges.rules.base import Binder, Condition, Firing, Number, Phrases, ValueWord
from rcj_challenges.rules.fields import MM_DIGITS, described
from rcj_challenges.rules.values import Amount, amount_words, compile_amount


def to_mm(metres: Number) -> Number:
    """Return a length rounded to the millimetre, as it would be counted."""
    return round(metres, MM_DIGITS)


def _unchanged(value: Number) -> Number:
    return value


def _test(
    operate: Callable[[Number, Number], bool],
    bound: Amount,
    to: Binder,
    rounded: Callable[[Number], Number],
    counted: Callable[[Number], Number],
) -> Callable[[Number], bool]:
    """Return a function that compares a number with a bound; with none nothing holds."""
    if not isinstance(bound, ValueWord):
        constant = rounded(bound)
        return lambda value: operate(value, constant)
    read, firing = compile_amount(bound, to), Firing(to.rule, None, "")

    def test(value: Number) -> bool:
        limit: Number | None = read(firing)
        return limit is not None and operate(counted(value), rounded(limit))

    return test


class _Bound(NamedTuple):
    """What a key compares.

    Attributes:
        says, opposite: in words; empty: its opposite has none.
    """

    holds: Callable[[Number, Number], bool]
    says: str
    opposite: str


_BOUNDS = {
    "at_least": _Bound(ge, "at least", "less than"),
    "at_most": _Bound(le, "at most", "more than"),
    "above": _Bound(gt, "more than", "at most"),
    "below": _Bound(lt, "less than", "at least"),
    "equals": _Bound(eq, "exactly", ""),
}


class Compared(Condition):
    """A condition with bounds, of which it has one at least."""

    EXCLUDES = (
        ("equals", ("at_least", "at_most", "above", "below")),
        ("above", ("at_least",)),
        ("below", ("at_most",)),
    )
    REQUIRES: ClassVar[tuple[tuple[str, ...], ...]] = tuple((key,) for key in _BOUNDS)

    at_least: Amount | None = described(None, "holds at this number and above")
    at_most: Amount | None = described(None, "holds at this number and below")
    above: Amount | None = described(None, "holds above this number, not at it")
    below: Amount | None = described(None, "holds below this number, not at it")
    equals: Amount | None = described(None, "holds at exactly this number")

    def limits(self) -> list[tuple[_Bound, Amount]]:
        """Return with what it compares, and how."""
        return [(bound, limit) for key, bound in _BOUNDS.items() if (limit := getattr(self, key)) is not None]

    def compares_with_counter(self) -> bool:
        """Return whether it compares with a counter, or with those of others."""
        return any(isinstance(limit, ValueWord) for _, limit in self.limits())

    def comparison(
        self, to: Binder, rounded: Callable[[Number], Number] = _unchanged,
        counted: Callable[[Number], Number] = _unchanged,
    ) -> Callable[[Number], bool]:  # fmt: skip
        """Return a function that compares a number with the bounds, which ``rounded`` rounds.

        ``counted`` is done to a number before it is compared with a value: as it would be counted.
        """
        tests = tuple(_test(bound.holds, limit, to, rounded, counted) for bound, limit in self.limits())
        if len(tests) == 1:
            return tests[0]
        return lambda value: all(test(value) for test in tests)

    def compared(self, phrases: Phrases, unit: str = "", where: str = "") -> str:
        """Return the comparison: ``at least 3 and at most 5``, ``at most 0.5 m from the ball``."""
        limits = self.limits()
        if all(isinstance(limit, int | float) for _, limit in limits):
            numbers = " and ".join(f"{bound.says} {amount_words(phrases, limit)}{unit}" for bound, limit in limits)
            return f"{numbers}{where}" if numbers else ""
        return " and ".join(
            f"{bound.says} {amount_words(phrases, limit)}{unit}{where}"
            if isinstance(limit, int | float) or not unit
            else f"{bound.says} as many{unit}{where} as {amount_words(phrases, limit)} says"
            for bound, limit in limits
        )

    def opposite(self, phrases: Phrases, unit: str = "") -> str | None:
        """Return the opposite of a comparison that has one limit: ``less than 0.5 m``; None if it cannot be put so."""
        (bound, limit), *more = self.limits() or [(_BOUNDS["equals"], 0)]
        if more or not bound.opposite or (unit and not isinstance(limit, int | float)):
            return None
        return f"{bound.opposite} {amount_words(phrases, limit)}{unit}"
