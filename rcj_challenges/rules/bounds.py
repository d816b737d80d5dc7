"""Floors and ceilings: how much an action pays or counts, and how far it takes a score or a counter."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rcj_challenges.core.amounts import plain
from rcj_challenges.rules.phrasing import number
from rcj_challenges.tracking.state import Number

if TYPE_CHECKING:
    from rcj_challenges.rules.actions.count import Count
    from rcj_challenges.rules.actions.score import Score


def amount_bound(model: "Count | Score") -> Callable[[Number], Number]:
    """Return a function that brings an amount between ``at_least`` and ``at_most``."""
    least, most = model.at_least, model.at_most

    def within(amount: Number) -> Number:
        if least is not None:
            amount = max(amount, plain(least))
        return amount if most is None else min(amount, plain(most))

    return within


def change_bound(model: "Count | Score") -> Callable[[Number, Number], Number]:
    """Return a function from an amount and the total before it to the amount that is added.

    It goes as far as ``keeps_at_least`` or ``keeps_at_most`` and no further. What lies beyond already stays where it
    is: losing points never raises a score.
    """
    within = amount_bound(model)
    least, most = model.keeps_at_least, model.keeps_at_most

    def change(amount: Number, before: Number) -> Number:
        amount = within(amount)
        if least is not None and amount < 0:
            return max(amount, min(0, plain(least) - before))
        if most is not None and amount > 0:
            return min(amount, max(0, plain(most) - before))
        return amount

    return change


def bounds_words(action: "Count | Score", total: str) -> str:
    """Return the bounds of an action's amount, and of the total, in words."""
    least, most = action.at_least, action.at_most
    amounts = [f"at {how} {number(one)}" for how, one in (("least", least), ("most", most)) if one is not None]
    ways = (("fall below", action.keeps_at_least), ("rise above", action.keeps_at_most))
    totals = [f"{way} {number(one)}" for way, one in ways if one is not None]
    said = [" and ".join(amounts), f"the {total} does not {' or '.join(totals)} by it" if totals else ""]
    return f" ({'; '.join(filter(None, said))})" if any(said) else ""


def subtracted_parts(action: "Count | Score", parts: Any) -> tuple[Any, ...]:
    """Return the parts of a sum that takes away only, without their signs; else, or with bounds, none."""
    is_bounded = action.at_least is not None or action.at_most is not None
    if is_bounded or not isinstance(parts, tuple):
        return ()
    weights = [part if isinstance(part, int | float) else part.weight for part in parts]
    if any(weight >= 0 for weight in weights):
        return ()
    return tuple(
        -part if isinstance(part, int | float) else part.model_copy(update={"weight": -part.weight}) for part in parts
    )
