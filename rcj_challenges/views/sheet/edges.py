"""Conditions as sentences."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from rcj_challenges.rules.phrasing import degrees, heading, listed, quoted_measure
from rcj_challenges.scenario.catalogue import EACH
from rcj_challenges.views.sheet.comparing import (
    counter_words,
    distance_words,
    flag_words,
    sequence_words,
    speed_words,
    timer_words,
    way_words,
)
from rcj_challenges.views.sheet.nouns import Nouns
from rcj_challenges.views.sheet.phrases import within_words


def condition_words(nouns: Nouns, condition: Any) -> str:
    """Return a condition, or the opposite of a negated one, as the part of a sentence that follows ``if``."""
    return CONDITIONS[condition.condition](nouns, condition)


def _is(nouns: Nouns, c: Any, names: Any, what: str) -> str:
    """Return that so many of the names are something, or are not."""
    return f"{nouns.quantified(c.of, names, negate=c.negate).does('is', 'are')} {what}"


def _looks(nouns: Nouns, c: Any) -> str:
    who = nouns.of_those_there(c.of, c.entity, negate=c.negate).does("looks", "look")
    way = heading(c.heading_rad) if c.towards is None else f"towards {nouns.point(c.towards)}"
    return f"{who} {way} (to within {degrees(c.within_rad)})"


def _last_touch(nouns: Nouns, c: Any) -> str:
    last, was = f"the last to touch {nouns.thing(c.entity)}", "was not" if c.negate else "was"
    return f"it {was} {last}" if c.by == "each" else f"{last} {was} {nouns.any_of(c.by)}"


def _heard(nouns: Nouns, c: Any) -> str:
    who, said = nouns.quantified(c.of, c.entity, negate=c.negate), c.said(nouns)
    if not said:
        return f"{who.does('was', 'were')} heard by the referee before"
    return f"{who.does('has', 'have')} {said} as the last message told"


def _any_of(nouns: Nouns, c: Any) -> str:
    parts = c.conditions
    if c.negate and (len(parts) == 1 or any(_is_negative(one) or one.is_several() for one in parts)):
        # None of them holds: of each the opposite does.
        return _all_hold(nouns, _opposites(parts))
    if c.negate:
        return "neither " + " nor ".join(condition_words(nouns, one) for one in parts)
    return _one_holds(nouns, parts)


def _all_of(nouns: Nouns, c: Any) -> str:
    # Not all of them hold: of one the opposite does.
    return _one_holds(nouns, _opposites(c.conditions)) if c.negate else _all_hold(nouns, c.conditions)


def _opposites(conditions: Sequence[Any]) -> list[Any]:
    return [one.model_copy(update={"negate": not one.negate}) for one in conditions]


def _all_hold(nouns: Nouns, parts: Sequence[Any]) -> str:
    # Behind a comma it is clear that it does not belong to the alternatives before it.
    joint = ", and " if any(one.is_several() for one in parts) else " and "
    return joint.join(condition_words(nouns, one) for one in parts)


def _one_holds(nouns: Nouns, parts: Sequence[Any]) -> str:
    inner = [_as_one(nouns, one) for one in parts]
    if len(inner) == 1:
        return condition_words(nouns, parts[0])
    return "either " + (", or " if any(one.is_several() for one in parts) else " or ").join(inner)


def _as_one(nouns: Nouns, c: Any) -> str:
    """Return a condition as one of several; if all of others must hold in it, as ``both … and …``."""
    if not c.is_several() or c.condition != "all_of" or c.negate:
        return condition_words(nouns, c)
    inner = [condition_words(nouns, one) for one in c.conditions]
    return f"both {inner[0]} and {inner[1]}" if len(inner) == 2 else f"{listed(inner, 'and')} at once"


def _is_negative(condition: Any) -> bool:
    """Return whether a condition says that something is not so: ``neither`` before it would deny that again."""
    return bool(condition.negate) or getattr(condition, "of", None) == "none"


def _drawn(nouns: Nouns, c: Any) -> str:
    who, draw, no = nouns.drawn(c.draw, c.equals), quoted_measure(c.draw), "not " if c.negate else ""
    if not nouns.is_set(c.draw):
        return f"{who} was {no}drawn as {draw}"
    return f"{who} is {no}{draw}" if who == nouns.thing(EACH) else f"{draw} is {no}{who}"


def _half(_nouns: Nouns, c: Any) -> str:
    if c.at_least is not None and c.at_least == c.at_most:
        which = f"half {c.at_least}"
    elif c.at_least is not None and c.at_most is not None:
        which = f"one of the halves {c.at_least} to {c.at_most}"
    elif c.at_least is not None:
        which = f"half {c.at_least} or a later one"
    else:
        which = f"half {c.equals}" if c.at_most is None else f"half {c.at_most} or an earlier one"
    return f"it is {'not ' if c.negate else ''}{which}"


CONDITIONS: dict[str, Callable[[Nouns, Any], str]] = {
    "in_zone": lambda n, c: (
        n.of_those_there(c.of, c.entity, negate=c.negate).does("is", "are") + f" in {n.any_of(c.zone)}"
    ),
    "speed": speed_words,
    "distance": distance_words,
    "way": way_words,
    "looks": _looks,
    "held": lambda n, c: _is(n, c, c.entity, "held"),
    "any_of": _any_of,
    "all_of": _all_of,
    "counter": counter_words,
    "flag": flag_words,
    "drawn": _drawn,
    "timer": timer_words,
    "last_touch": _last_touch,
    "told": _heard,
    "spot_free": lambda n, c: _is(n, c, c.spot, "free" + within_words(c.clearance_m)),
    "sequence_at": sequence_words,
    "half": _half,
}
