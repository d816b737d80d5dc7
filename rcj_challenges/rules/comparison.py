"""Comparing what is measured or counted with numbers."""

from collections.abc import Callable
from operator import eq, ge, le
from typing import ClassVar

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


class Compared(Condition):
    """A condition with bounds, of which it has one at least."""

    EXCLUDES = (("equals", ("at_least", "at_most")),)
    REQUIRES: ClassVar[tuple[tuple[str, ...], ...]] = (("at_least",), ("at_most",), ("equals",))

    at_least: Amount | None = described(None, "holds at this number and above")
    at_most: Amount | None = described(None, "holds at this number and below")
    equals: Amount | None = described(None, "holds at exactly this number")

    def compares_with_counter(self) -> bool:
        """Return whether it compares with a counter, or with those of others."""
        bounds = (self.at_least, self.at_most, self.equals)
        return any(isinstance(bound, ValueWord) for bound in bounds)

    def comparison(
        self, to: Binder, rounded: Callable[[Number], Number] = _unchanged,
        counted: Callable[[Number], Number] = _unchanged,
    ) -> Callable[[Number], bool]:  # fmt: skip
        """Return a function that compares a number with the bounds, which ``rounded`` rounds.

        ``counted`` is done to a number before it is compared with a value: as it would be counted.
        """
        bounds = ((ge, self.at_least), (le, self.at_most), (eq, self.equals))
        tests = tuple(_test(operate, bound, to, rounded, counted) for operate, bound in bounds if bound is not None)
        if len(tests) == 1:
            return tests[0]
        return lambda value: all(test(value) for test in tests)

    def compared(self, phrases: Phrases, unit: str = "", where: str = "") -> str:
        """Return the comparison: ``at least 3 and at most 5``, ``at most 0.5 m from the ball``."""
        bounds = (("at least", self.at_least), ("at most", self.at_most), ("exactly", self.equals))
        limits = [(words, limit) for words, limit in bounds if limit is not None]
        if all(isinstance(limit, int | float) for _, limit in limits):
            numbers = " and ".join(f"{words} {amount_words(phrases, limit)}{unit}" for words, limit in limits)
            return f"{numbers}{where}" if numbers else ""
        return " and ".join(
            f"{words} {amount_words(phrases, limit)}{unit}{where}"
            if isinstance(limit, int | float) or not unit
            else f"{words} as many{unit}{where} as {amount_words(phrases, limit)} says"
            for words, limit in limits
        )

    def opposite(self, phrases: Phrases, unit: str = "") -> str | None:
        """Return the opposite of a comparison that has one limit: ``less than 0.5 m``; None if it cannot be put so."""
        limits = [limit for limit in (self.at_least, self.at_most) if limit is not None]
        if len(limits) != 1 or self.equals is not None or (unit and not isinstance(limits[0], int | float)):
            return None
        return f"{'less' if self.at_most is None else 'more'} than {amount_words(phrases, limits[0])}{unit}"
