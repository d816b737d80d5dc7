"""How many of a group must satisfy a condition."""

from collections.abc import Iterable
from typing import Annotated, Literal

from pydantic import Field

from rcj_challenges.rules.fields import Strict, described


class AtLeast(Strict):
    """At least so many of a group."""

    at_least: int = described(..., "how many", ge=1)


Quantifier = Annotated[
    Literal["any", "all", "none"] | AtLeast,
    Field(union_mode="left_to_right", description="how many of a group: any, all, none, {at_least: n}"),
]


def quantified(of: Quantifier, results: Iterable[bool]) -> bool:
    """Return whether so many of the results are true as asked for."""
    if of == "any":
        return any(results)
    if of == "none":
        return not any(results)
    judged = list(results)
    if isinstance(of, AtLeast):
        return sum(judged) >= of.at_least  # integers
    # "all" of none says nothing: with all of them off the field it does not hold.
    return bool(judged) and all(judged)
