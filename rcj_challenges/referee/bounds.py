"""Floors and ceilings: how much an action pays or counts, and how far it takes a score or a counter."""

from __future__ import annotations

from collections.abc import Callable

from rcj_challenges.facts.amounts import plain
from rcj_challenges.rules.actions import Bounded
from rcj_challenges.tracking.state import Number


def amount_bound(model: Bounded) -> Callable[[Number], Number]:
    """Return what brings an amount between ``at_least`` and ``at_most``."""
    least, most = model.at_least, model.at_most

    def within(amount: Number) -> Number:
        if least is not None:
            amount = max(amount, plain(least))
        return amount if most is None else min(amount, plain(most))

    return within


def change_bound(model: Bounded) -> Callable[[Number, Number], Number]:
    """Return what an amount becomes that is added to a score or a counter, given what that is before.

    It goes as far as ``keeps_at_least`` or ``keeps_at_most`` and no further. What lies beyond already stays where it
    is: nobody gains by losing points.
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
