"""The action ``count``."""

from collections.abc import Callable, Iterable
from typing import Annotated, Any, Literal

from rcj_challenges.core.amounts import plain, round_score
from rcj_challenges.rules.base import Act, Action, Binder, Firing, Number, Phrases
from rcj_challenges.rules.fields import Name, Names, described
from rcj_challenges.rules.number import takes_away
from rcj_challenges.rules.phrasing import number
from rcj_challenges.rules.refs import WHOSE_OF, WRITTEN_COUNTER
from rcj_challenges.rules.values import Amount, amount_words, compile_amount
from rcj_challenges.rules.values.counter import CounterValue


class Count(Action):
    """Change a counter."""

    action: Literal["count"]
    counter: Annotated[Name, WRITTEN_COUNTER] = described(..., "the counter")
    entity: Annotated[Names | None, WHOSE_OF] = described(
        None, "if it is kept per entity: whose; if omitted: that of each in a rule for_each of its owners, else all"
    )
    by: Amount | None = described(
        None, "what is added; 1 if neither `by` nor `to` is given; if there is no such number, nothing"
    )
    to: Amount | None = described(
        None, "the new value, or one of which it keeps the best; if there is no such number, it keeps its value"
    )
    keeps_at_least: float | None = described(
        None, "with `by`: the counter does not fall below this; a value that is already lower stays unchanged"
    )
    keeps_at_most: float | None = described(
        None, "with `by`: the counter does not rise above this; a value that is already higher stays unchanged"
    )

    EXCLUDES = (("to", ("by", "keeps_at_least", "keeps_at_most")),)
    EXAMPLE = CounterValue.EXAMPLE

    def compile(self, to: Binder) -> Act:
        """Return a function that changes a counter: first ``to``, then ``by``."""
        counters, name, whose = to.state.counters, self.counter, to.owners("counters", self.counter, self.entity)
        new = None if self.to is None else compile_amount(self.to, to)
        by = 1 if self.by is None and self.to is None else self.by
        step = None if by is None else compile_amount(by, to)
        bounded, best_of = change_bound(self), to.state.keeps.get(name)

        def changed(value: Number | None, firing: Firing) -> Number | None:
            start, change = value if new is None else new(firing), 0 if step is None else step(firing)
            if start is None or change is None:
                return value
            if new is not None and best_of is not None and value is not None:
                start = best_of(value, start)
            return round_score(start + bounded(change, start))

        def act(firing: Firing) -> None:
            change_kept(counters, name, whose, lambda value: changed(value, firing))

        return act

    def describe(self, phrases: Phrases) -> str:
        counter = phrases.every_kept("counter", self.counter, self.entity)
        bounds = bounds_words(self, "counter")
        if self.to is not None:
            return f"{counter} is set to {amount_words(phrases, self.to)}{bounds}"
        if isinstance(self.by, int | float) and self.by < 0:
            return f"{counter} falls by {amount_words(phrases, -self.by)}{bounds}"
        if self.by is not None and takes_away(self.by):
            return f"{counter} falls by {amount_words(phrases, self.by, negate=True)}{bounds}"
        return f"{counter} grows by {amount_words(phrases, 1 if self.by is None else self.by)}{bounds}"


# --- floors and ceilings: how far an action takes a score or a counter ------------------------------------------------


_BOUNDS = {"keeps_at_least": "fall below", "keeps_at_most": "rise above"}


def change_bound(model: Action) -> Callable[[Number, Number], Number]:
    """Return a function from an amount and the total before it to the amount that is added.

    It goes as far as ``keeps_at_least`` or ``keeps_at_most`` and no further. What lies beyond already stays where it
    is: losing points never raises a score.
    """
    least, most = (getattr(model, key) for key in _BOUNDS)

    def change(amount: Number, before: Number) -> Number:
        if least is not None and amount < 0:
            return max(amount, min(0, plain(least) - before))
        if most is not None and amount > 0:
            return min(amount, max(0, plain(most) - before))
        return amount

    return change


def bounds_words(action: Action, total: str) -> str:
    """The change of the total by an action, in words."""
    ways = ((way, getattr(action, key)) for key, way in _BOUNDS.items())
    totals = [f"{way} {number(one)}" for way, one in ways if one is not None]
    return f" (the {total} does not {' or '.join(totals)} by it)" if totals else ""


def change_kept(kept: dict[str, Any], name: str, whose: Iterable[str] | None, changed: Callable[[Any], Any]) -> None:
    """Change a counter or a flag, of several that of some owners; None: of all."""
    value = kept[name]
    if isinstance(value, dict):
        for member in value if whose is None else whose:
            value[member] = changed(value[member])
    else:
        kept[name] = changed(value)
