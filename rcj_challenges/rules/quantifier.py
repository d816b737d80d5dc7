"""How many of a group must satisfy a condition."""

from collections.abc import Iterable
from typing import Annotated, Literal

from pydantic import Field

from rcj_challenges.rules.fields import Strict, described


class HowMany(Strict):
    """So many of a group."""

    either = ("at_least", "at_most", "equals")

    at_least: int | None = described(None, "so many or more", ge=1)
    at_most: int | None = described(None, "so many or fewer, also none", ge=0)
    equals: int | None = described(None, "exactly so many", ge=0)

    @property
    def number(self) -> int:
        """How many."""
        return next(one for one in (self.at_least, self.at_most, self.equals) if one is not None)

    def fits(self, count: int) -> bool:
        """Return whether so many are enough, and not too many."""
        if self.at_most is not None:
            return count <= self.at_most
        return count >= self.number if self.equals is None else count == self.equals

    def describe(self, *, negate: bool) -> str:
        """Return it in words, or its opposite: ``at least 2``, ``fewer than 2``."""
        if self.at_least is not None:
            return f"{'fewer than' if negate else 'at least'} {self.at_least}"
        if self.at_most is not None:
            return f"{'more than' if negate else 'at most'} {self.at_most}"
        return f"{'not exactly' if negate else 'exactly'} {self.equals}"


Quantifier = Annotated[
    Literal["any", "all", "none"] | HowMany,
    Field(
        union_mode="left_to_right",
        description="how many of a group: any, all, none, {at_least: n}, {at_most: n}, {equals: n}",
    ),
]


def quantified(of: Quantifier, results: Iterable[bool]) -> bool:
    """Return whether so many of the results are true as asked for."""
    if of == "any":
        return any(results)
    if of == "none":
        return not any(results)
    judged = list(results)
    if isinstance(of, HowMany):
        return of.fits(sum(judged))  # integers
    # "all" of none says nothing: with all of them off the field it does not hold.
    return bool(judged) and all(judged)
