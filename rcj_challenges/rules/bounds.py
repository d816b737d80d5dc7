"""Floors and ceilings: how far an action takes a score or a counter."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from rcj_challenges.core.amounts import plain
from rcj_challenges.rules.phrasing import number
from rcj_challenges.tracking.state import Number

if TYPE_CHECKING:
    from rcj_challenges.rules.actions.count import Count
    from rcj_challenges.rules.actions.score import Score


def change_bound(model: "Count | Score") -> Callable[[Number, Number], Number]:
    """Return a function from an amount and the total before it to the amount that is added.

    It goes as far as ``keeps_at_least`` or ``keeps_at_most`` and no further. What lies beyond already stays where it
    is: losing points never raises a score.
    """
    least, most = model.keeps_at_least, model.keeps_at_most

    def change(amount: Number, before: Number) -> Number:
        if least is not None and amount < 0:
            return max(amount, min(0, plain(least) - before))
        if most is not None and amount > 0:
            return min(amount, max(0, plain(most) - before))
        return amount

    return change


def bounds_words(action: "Count | Score", total: str) -> str:
    """The change of the total by an action, in words."""
    ways = (("fall below", action.keeps_at_least), ("rise above", action.keeps_at_most))
    totals = [f"{way} {number(one)}" for way, one in ways if one is not None]
    return f" (the {total} does not {' or '.join(totals)} by it)" if totals else ""
