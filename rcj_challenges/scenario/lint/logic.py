"""What conditions say together, for lint: in which ways they can hold, and which of them never hold at once."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import product
from typing import Any

from rcj_challenges.scenario.catalogue import BOUND, EACH
from rcj_challenges.scenario.followed import followed
from rcj_challenges.scenario.heard import fits, wanted
from rcj_challenges.scenario.lint.suspect import Subject
from rcj_challenges.scenario.models.conditions import (
    Condition,
    CounterIs,
    Distance,
    Drawn,
    HalfIs,
    InZone,
    LastTouch,
    SequenceAt,
    Speed,
    TimerIs,
    Told,
    WayIs,
)
from rcj_challenges.scenario.models.places import CircleZone, HalfPlaneZone, PolygonZone, RectZone, Zone
from rcj_challenges.scenario.models.scenario import Rule

Way = tuple[Condition, ...]
"""Single conditions that hold at once."""

_MOST_WAYS = 256
"""More ways than this are no longer looked through."""
_BOUNDS = frozenset({"at_least", "at_most", "equals"})
_NAMING = ("entity", "zone", "step", "to", "towards", "by", "equals")
_FAR_M = float("inf")


# --- ways to hold -----------------------------------------------------------------------------------------------------


def ways_to_hold(conditions: Iterable[Condition]) -> list[Way] | None:
    """Return the ways in which conditions can hold together, each as single conditions; None: too many to tell.

    What is made of several (``any_of``, ``all_of``) is taken apart, and a negated one turned over.
    """
    return _together([_ways(condition, turned=False) for condition in conditions])


def _ways(condition: Condition, *, turned: bool) -> list[Way] | None:
    parts = parts_of(condition)
    if not parts:
        return [(condition.model_copy(update={"negate": not condition.negate}) if turned else condition,)]
    turned = condition.negate != turned
    several = [_ways(part, turned=turned) for part in parts]
    # Of any_of one must hold; turned over, each must fail, as if it were all_of.
    if (condition.condition == "any_of") == turned:
        return _together(several)
    found = [way for ways in several for way in ways or ()]
    return None if None in several or len(found) > _MOST_WAYS else found


def _together(several: list[list[Way] | None]) -> list[Way] | None:
    found: list[Way] = [()]
    for ways in several:
        if ways is None or len(found) * len(ways) > _MOST_WAYS:
            return None
        found = [(*before, *way) for before, way in product(found, ways)]
    return found


def parts_of(condition: Condition) -> tuple[Condition, ...]:
    """Return the conditions of which one is made, or nothing for a single one."""
    parts: tuple[Condition, ...] = getattr(condition, "conditions", ())
    return parts


def with_each(condition: Condition, each: str | None) -> Condition:
    """Return a single condition with the name for which ``each`` stands, if that is known."""
    if each is None:
        return condition
    named = {key: _replaced(getattr(condition, key), each) for key in _NAMING if hasattr(condition, key)}
    return condition.model_copy(update=named)


def _replaced(names: Any, each: str) -> Any:
    if isinstance(names, tuple):
        return tuple(each if name == "each" else name for name in names)
    return each if names == "each" else names


# --- what never holds at once -----------------------------------------------------------------------------------------


def exclude(one: Condition, other: Condition, rules: tuple[Rule, Rule], subject: Subject) -> bool:
    """Return whether two single conditions, each of its rule, can never hold together."""
    if type(one) is not type(other):
        return False
    one, other = without_none(one), without_none(other)
    if one == other.model_copy(update={"negate": not other.negate}):
        return True
    return not (one.negate or other.negate) and _have_nothing_in_common(one, other, rules, subject)


def without_none(condition: Condition) -> Condition:
    """Return a condition as it reads with `any`: none of them is not any of them."""
    if getattr(condition, "of", None) != "none":
        return condition
    return condition.model_copy(update={"of": "any", "negate": not condition.negate})


def _have_nothing_in_common(one: Condition, other: Condition, rules: tuple[Rule, Rule], subject: Subject) -> bool:
    match one, other:
        case CounterIs() | TimerIs() | Speed() | Distance() | WayIs() | HalfIs(), _:
            of_one = isinstance(one, HalfIs) or _is_of_one(one, rules[0], subject)
            return of_one and _same_but(one, other, _BOUNDS) and _apart(one, other)
        case InZone(), InZone():
            return _in_two_zones(one, other, rules, subject)
        case Drawn(), Drawn():
            values = (_drawable(drawn, rule, subject) for drawn, rule in zip((one, other), rules, strict=True))
            return one.draw == other.draw and not frozenset.intersection(*values)
        case LastTouch(), LastTouch():
            by, by_other = subject.members(one.by, rules[0]), subject.members(other.by, rules[1])
            return one.entity == other.entity not in BOUND and not by & by_other
        case SequenceAt(), SequenceAt():
            return _at_two_steps(one, other, rules, subject)
    return isinstance(one, Told) and isinstance(other, Told) and _say_otherwise(one, other, rules, subject)


def _say_otherwise(one: Told, other: Told, rules: tuple[Rule, Rule], subject: Subject) -> bool:
    """Return whether the same robots would have to have said two things at last."""
    if (one.entity, one.of) != (other.entity, other.of) or not _is_of_one(one, rules[0], subject):
        return False
    for message, same in ((one, other), (other, one)):
        said = wanted(message, subject.scenario)
        if said is not None:
            return not any(
                fits(text, message, subject.scenario) and fits(text, same, subject.scenario) for text in said
            )
    return None not in (one.is_a, other.is_a) and one.is_a != other.is_a


def _drawable(condition: Drawn, rule: Rule, subject: Subject) -> frozenset[Any]:
    """Return the values of a draw for which a condition holds: those of all for whom ``each`` or ``other`` stands."""
    value = condition.equals
    return subject.members(value, rule) if isinstance(value, str) and value in BOUND else frozenset({value})


def _same_but(one: Condition, other: Condition, keys: frozenset[str]) -> bool:
    return one.model_dump(exclude=set(keys)) == other.model_dump(exclude=set(keys))


def _is_of_one(condition: Any, rule: Rule, subject: Subject) -> bool:
    """Return whether a comparison is about a single value, or about each of several."""
    if condition.of in (None, "all"):
        return True
    names = condition.entity
    return condition.of == "any" and names is not None and len(subject.members(names, rule)) == 1


def _at_two_steps(one: SequenceAt, other: SequenceAt, rules: tuple[Rule, Rule], subject: Subject) -> bool:
    """Return whether a sequence would have to stand at two steps at once."""
    steps, other_steps = subject.members(one.step, rules[0]), subject.members(other.step, rules[1])
    same = _is_of_one_way(one, rules[0], subject) and _same_but(one, other, frozenset({"step"}))
    return same and not steps & other_steps


def _is_of_one_way(condition: SequenceAt, rule: Rule, subject: Subject) -> bool:
    """Return whether a condition asks for the step of a single sequence, or of each of several."""
    whose = condition.entity or followed(subject.scenario.sequences[condition.sequence])
    asks_all = condition.of == "all" or (condition.of is None and condition.entity is not None)
    return asks_all or (condition.of in (None, "any") and len(subject.members(whose, rule)) == 1)


def _apart(one: Any, other: Any) -> bool:
    (low, high), (lower, higher) = range_of(one), range_of(other)
    return high < lower or higher < low


def range_of(condition: Any) -> tuple[float, float]:
    """Return between which numbers something must be, as far as they stand in the file."""
    low, high = condition.at_least, condition.at_most
    if isinstance(condition.equals, int | float):
        return condition.equals, condition.equals
    return (
        low if isinstance(low, int | float) else float("-inf"),
        high if isinstance(high, int | float) else float("inf"),
    )


def _in_two_zones(one: InZone, other: InZone, rules: tuple[Rule, Rule], subject: Subject) -> bool:
    who, whose = subject.members(one.entity, rules[0]), subject.members(other.entity, rules[1])
    same = one.entity == other.entity == EACH or (who == whose and len(who) == 1)
    if not same or {one.of, other.of} - {"any", "all"}:
        return False
    zones = subject.scenario.zones
    first, second = subject.members(one.zone, rules[0]), subject.members(other.zone, rules[1])
    return all(are_apart(zones[here], zones[there]) for here, there in product(first, second))


def are_apart(zone: Zone, other: Zone) -> bool:
    """Return whether there is room between two zones, as far as the rectangles around them tell."""
    # Limits are strict: who is on a common side is in neither.
    return any(
        high <= lower or higher <= low
        for (low, high), (lower, higher) in zip(_around(zone), _around(other), strict=True)
    )


def _around(zone: Zone) -> tuple[tuple[float, float], tuple[float, float]]:
    everywhere = ((-_FAR_M, _FAR_M), (-_FAR_M, _FAR_M))
    if zone.inverted:
        return everywhere
    match zone:
        case RectZone():
            return (
                (_or(zone.x_min_m, -_FAR_M), _or(zone.x_max_m, _FAR_M)),
                (_or(zone.y_min_m, -_FAR_M), _or(zone.y_max_m, _FAR_M)),
            )
        case CircleZone():
            (x_m, y_m), radius_m = zone.centre_m, zone.radius_m
            return (x_m - radius_m, x_m + radius_m), (y_m - radius_m, y_m + radius_m)
        case PolygonZone():
            xs, ys = zip(*zone.points_m, strict=True)
            return (min(xs), max(xs)), (min(ys), max(ys))
        case HalfPlaneZone():
            return everywhere


def _or(number: float | None, instead: float) -> float:
    return instead if number is None else number
