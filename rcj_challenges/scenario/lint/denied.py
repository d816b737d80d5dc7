"""Lint of conditions that never hold together, or that the edge of a trigger of their rule denies: it never fires."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import combinations, product

from rcj_challenges.facts.timing import s_from_ticks, ticks_from_s
from rcj_challenges.scenario.lint.logic import are_apart, exclude, range_of, ways_to_hold
from rcj_challenges.scenario.lint.suspect import Subject, Suspect, lengths_s
from rcj_challenges.scenario.messages.written import as_written
from rcj_challenges.scenario.models.conditions import Condition, InZone, TimerIs
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.triggers import Enters, Holds, Leaves, StaysIn, TimerExpired, Trigger
from rcj_challenges.scenario.tree import Path

_NEVER_TOGETHER = "all of them must hold, and two of them never do at the same time"
_ONE_SUFFICES = "take one of them out, or write those of which one suffices as {condition: any_of, conditions: […]}"


def check_contradictions(subject: Subject) -> Iterator[Suspect]:
    """Conditions of a rule that never hold together; triggers whose own edge denies one of them."""
    for name, rule in subject.scenario.rules.items():
        if _never_hold(rule.conditions, rule, subject):
            reason = _never_together(rule.conditions, rule, subject)
            yield Suspect("rule_never_fires", ("rules", name, "conditions"), reason, _ONE_SUFFICES, at_key=True)
            continue
        ways = ways_to_hold(rule.conditions)
        for index, trigger in enumerate(rule.triggers):
            path = ("rules", name, "triggers", index)
            if isinstance(trigger, Holds):
                yield from _of_lasting(trigger, rule, path, subject)
            elif ways and all(any(_denies(trigger, one, rule, subject) for one in way) for way in ways):
                yield Suspect("rule_never_fires", path, *_why(trigger))


def _of_lasting(trigger: Holds, rule: Rule, path: Path, subject: Subject) -> Iterator[Suspect]:
    """A condition that must last and never holds, or not with those of the rule; with a grace it may just be broken."""
    if _never_hold((trigger.condition,), rule, subject):
        yield Suspect("rule_never_fires", path, _never_together((trigger.condition,), rule, subject), _ONE_SUFFICES)
    elif not trigger.grace_s and _never_hold((trigger.condition, *rule.conditions), rule, subject):
        reason = "when it fires its condition holds, and one of the rule's conditions never does at the same time"
        yield Suspect("rule_never_fires", path, reason, "take that condition out, or let the trigger wait for another")


def _never_hold(conditions: Iterable[Condition], rule: Rule, subject: Subject) -> bool:
    """Return whether conditions can never all hold together."""
    ways, both = ways_to_hold(conditions) or (), (rule, rule)
    return bool(ways) and all(
        any(exclude(one, two, both, subject) for one, two in combinations(way, 2)) for way in ways
    )


def _never_together(conditions: Iterable[Condition], rule: Rule, subject: Subject) -> str:
    """Return that two conditions never hold together; of more than two with the ones that are meant."""
    ways = ways_to_hold(conditions) or ()
    if len(ways) != 1 or len(ways[0]) == 2:
        return _NEVER_TOGETHER
    both = next(pair for pair in combinations(ways[0], 2) if exclude(*pair, (rule, rule), subject))
    return f"{_NEVER_TOGETHER}: {' and '.join(map(as_written, both))}"


def _why(trigger: Trigger) -> tuple[str, str]:
    if isinstance(trigger, TimerExpired):
        return (
            "when it fires the timer has run out and stands at its length, and a condition asks for something else",
            "take the condition out: a timer that has run out is running no longer",
        )
    now, asked = ("in", "elsewhere") if isinstance(trigger, Enters | StaysIn) else ("outside", "inside")
    return (
        f"when it fires the entity is {now} the zone already, and a condition asks that it is {asked}",
        "take the condition or the trigger out, or correct the zone",
    )


def _denies(trigger: Trigger, condition: Condition, rule: Rule, subject: Subject) -> bool:
    # A grace counts as a stay, so that it may be outside just then.
    if isinstance(trigger, StaysIn) and trigger.grace_s:
        return False
    if isinstance(trigger, Enters | Leaves | StaysIn) and isinstance(condition, InZone):
        return _is_elsewhere(trigger, condition, rule, subject)
    if isinstance(trigger, TimerExpired) and isinstance(condition, TimerIs) and condition.timer == trigger.timer:
        return _is_of_expired(condition, rule, subject) and not _may_hold_at_end(condition, subject)
    return False


# --- zones ------------------------------------------------------------------------------------------------------------


def _is_elsewhere(trigger: Enters | Leaves | StaysIn, condition: InZone, rule: Rule, subject: Subject) -> bool:
    """Return whether one entity that has just entered is asked to be outside, or one that left to be inside."""
    if not _is_same_one(trigger, condition, rule, subject):
        return False
    asked_inside = (condition.of == "none") == condition.negate
    if rule.for_each is not None and "each" in (trigger.zone, condition.zone):
        members = subject.members("each", rule)
        whose = (rule.model_copy(update={"for_each": member}) for member in members)
        return all(_denies_place(trigger, condition, one, subject, asked_inside=asked_inside) for one in whose)
    return _denies_place(trigger, condition, rule, subject, asked_inside=asked_inside)


def _denies_place(
    trigger: Enters | Leaves | StaysIn, condition: InZone, rule: Rule, subject: Subject, *, asked_inside: bool
) -> bool:
    entered = isinstance(trigger, Enters | StaysIn)
    if trigger.zone == condition.zone:
        return entered != asked_inside
    if entered and asked_inside:
        zones = subject.scenario.zones
        here, there = subject.members(trigger.zone, rule), subject.members(condition.zone, rule)
        return all(are_apart(zones[one], zones[other]) for one, other in product(here, there))
    if entered:
        return subject.members(trigger.zone, rule) <= subject.surely(condition.zone, rule)
    return asked_inside and subject.members(condition.zone, rule) <= subject.surely(trigger.zone, rule)


def _is_same_one(trigger: Enters | Leaves | StaysIn, condition: InZone, rule: Rule, subject: Subject) -> bool:
    found = subject.members(trigger.entity, rule)
    alone = len(found) == 1 and found == subject.members(condition.entity, rule)
    return alone or trigger.entity == condition.entity == "each"


# --- timers -----------------------------------------------------------------------------------------------------------


def _is_of_expired(condition: TimerIs, rule: Rule, subject: Subject) -> bool:
    """Return whether a condition is about the very timer that has run out, and not about others of its name."""
    per = subject.scenario.timers[condition.timer].per
    if per is None or len(subject.members(per, rule)) == 1:
        return condition.of in (None, "any", "all")
    # A rule with for_each hears the timer of `each` only.
    return condition.of is None and condition.entity == "each"


def _may_hold_at_end(condition: TimerIs, subject: Subject) -> bool:
    """Return whether a condition can hold of a timer that stands at its length."""
    bounds = [bound for bound in (condition.at_least, condition.at_most, condition.equals) if bound is not None]
    if not bounds:
        return condition.negate  # whether it is running
    if not all(isinstance(bound, int | float) for bound in bounds):
        return True  # a bound that is a counter may be anything
    low, high = range_of(condition)
    lengths = lengths_s(subject.scenario.timers[condition.timer].lasts_s, subject.scenario)
    if not lengths:
        return True  # as long as a counter says
    # The referee counts in whole ticks.
    return any((low <= s_from_ticks(ticks_from_s(length)) <= high) != condition.negate for length in lengths)
