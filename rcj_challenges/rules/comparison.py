"""Comparing what is measured or counted with numbers and counters."""

from collections.abc import Callable
from typing import ClassVar

from rcj_challenges.rules.base import Binder, Condition, Number, Phrases, ValueWord
from rcj_challenges.rules.fields import MM_DIGITS, described
from rcj_challenges.rules.values import Bound, amount_words, compile_bound


def to_mm(metres: Number) -> Number:
    """Return a length rounded to the millimetre, as it would be counted."""
    return round(metres, MM_DIGITS)


def _unchanged(value: Number) -> Number:
    return value


class Compared(Condition):
    """A condition with bounds, of which it has one at least."""

    EXCLUDES = (("equals", ("at_least", "at_most")),)
    REQUIRES: ClassVar[tuple[tuple[str, ...], ...]] = (("at_least",), ("at_most",), ("equals",))

    at_least: Bound | None = described(
        None, "holds at this value and above; a number, {counter: NAME}, {lowest: NAME} or {highest: NAME}"
    )
    at_most: Bound | None = described(
        None, "holds at this value and below; a number, {counter: NAME}, {lowest: NAME} or {highest: NAME}"
    )
    equals: Bound | None = described(
        None, "holds at exactly this value; a number, {counter: NAME}, {lowest: NAME} or {highest: NAME}"
    )

    def compares_with_counter(self) -> bool:
        """Return whether it compares with a counter, or with those of others."""
        bounds = (self.at_least, self.at_most, self.equals)
        return any(isinstance(bound, ValueWord) for bound in bounds)

    def comparison(
        self, to: Binder, rounded: Callable[[Number], Number] = _unchanged,
        counted: Callable[[Number], Number] = _unchanged,
    ) -> Callable[[Number], bool]:  # fmt: skip
        """Return a function that compares a number with the bounds, which ``rounded`` rounds.

        ``counted`` is done to a number before it is compared with a counter: as it would be counted.
        """
        bounds = (self.at_least, self.at_most, self.equals)
        least, most, equals = (None if bound is None else compile_bound(bound, to) for bound in bounds)
        for_least, for_most, for_equals = (
            _unchanged if isinstance(bound, int | float) else counted for bound in bounds
        )

        def holds(value: Number) -> bool:
            return (
                (least is None or for_least(value) >= rounded(least()))
                and (most is None or for_most(value) <= rounded(most()))
                and (equals is None or for_equals(value) == rounded(equals()))
            )

        return holds

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
