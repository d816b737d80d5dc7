"""What the limits ``lowest`` and ``highest`` share."""

from collections.abc import Callable
from math import nan

from rcj_challenges.rules.base import Number, Scope


def of_others(pick: Callable[[list[Number]], Number], counter: str, to: Scope) -> Callable[[], Number]:
    """Return a function that picks from the values that a counter has for all but ``each``.

    It reads not a number, with which no comparison holds, if there are no others on the field, or ``each`` is not.
    """
    counters, each, is_present = to.state.counters, to.each, to.is_present

    def read() -> Number:
        kept = counters[counter]
        if not isinstance(kept, dict) or (each is not None and not is_present(each)):
            return nan
        values = [value for member, value in kept.items() if member != each and is_present(member)]
        return pick(values) if values else nan

    return read
