"""Lint of who is off the field and meant by a rule all the same: "not in the zone" is true of what is nowhere."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.catalogue import EACH
from rcj_challenges.scenario.floor import floor_parts
from rcj_challenges.scenario.floor_shapes import lies_in
from rcj_challenges.scenario.lint.logic import Way, ways_to_hold, without_none
from rcj_challenges.scenario.lint.suspect import Subject, Suspect, lengths_s
from rcj_challenges.scenario.models.actions import Remove, Score
from rcj_challenges.scenario.models.conditions import Condition, Distance, HalfIs, InZone, Looks, Speed
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.triggers import Holds, OnEvent, PhaseEntered, TimeReached, TimerExpired, Trigger

_WHOLE_FIELD = "pitch"
_FOR_EVER = float("inf")


def check_gone(subject: Subject) -> Iterator[Suspect]:
    """Rules that put back, or give points for, who is off the field, for what is negated is true of it."""
    for name, rule in subject.standing():
        touched = _put_or_scored(rule, subject)
        for index, trigger in enumerate(rule.triggers):
            patience_s = _patience_s(trigger)
            if patience_s is None or not touched:
                continue
            asked = (trigger.condition,) if isinstance(trigger, Holds) else ()
            meant = {
                who: takes_off
                for who, (takes_off, away_s) in _taken_off(subject, name).items()
                if who in touched and away_s > patience_s and _means(who, (*asked, *rule.conditions), rule, subject)
            }
            if meant:
                who, takes_off = next(iter(meant.items()))
                more = f" (and of {len(meant) - 1} more)" if len(meant) > 1 else ""
                yield Suspect(
                    "meant_off_the_field",
                    ("rules", name, "triggers", index),
                    f"what it asks is true of '{who}'{more} also while '{takes_off}' has taken it off the field, "
                    f"for it is nowhere then: the rule {touched[who]}",
                    f"add what is true on the field only to its conditions: {_presence(rule, who, subject)}",
                )


def _put_or_scored(rule: Rule, subject: Subject) -> dict[str, str]:
    """Return whom a rule puts somewhere, or gives or takes points for, with words for it."""
    scores = any(isinstance(action, Score) and action.entrant == EACH for action in rule.actions)
    scored = subject.members(EACH, rule) if scores and rule.for_each is not None else frozenset[str]()
    return {
        **dict.fromkeys(sorted(scored), "gives or takes points for it"),
        **dict.fromkeys(sorted(subject.put(rule)), "brings it back"),
    }


def _patience_s(trigger: Trigger) -> float | None:
    """Return how long something must be off the field for a trigger to mean it, in s; None: it never does."""
    if isinstance(trigger, Holds):
        # Without for_s it does not hear what a removal makes true.
        return trigger.for_s or None
    if isinstance(trigger, OnEvent):
        return 0.0 if trigger.entity is None else None
    return 0.0 if isinstance(trigger, TimeReached | TimerExpired | PhaseEntered) else None


def _taken_off(subject: Subject, but: str) -> dict[str, tuple[str, float]]:
    """Return which rule takes what off the field, the longest first, and for how long in s."""
    found: dict[str, tuple[str, float]] = {}
    for name, rule in subject.standing():
        for action in rule.actions:
            if not isinstance(action, Remove) or name == but:
                continue
            away_s = _FOR_EVER
            if action.for_s is not None:
                away_s = max(lengths_s(action.for_s, subject.scenario), default=_FOR_EVER)
            for who in sorted(subject.members(action.entity, rule)):
                if away_s > found.get(who, ("", 0.0))[1]:
                    found[who] = (name, away_s)
    return found


def _means(who: str, conditions: tuple[Condition, ...], rule: Rule, subject: Subject) -> bool:
    """Return whether conditions ask for nothing but what is true of who is off the field."""
    ways = ways_to_hold(conditions) or ()
    return any(_is_of_the_gone(way, who, rule, subject) for way in ways)


def _is_of_the_gone(way: Way, who: str, rule: Rule, subject: Subject) -> bool:
    # Whatever else is asked for may be how the author keeps them apart: a flag, a counter, a timer.
    asked = [condition for condition in way if not isinstance(condition, HalfIs)]
    return bool(asked) and all(_is_negated_of(condition, who, rule, subject) for condition in asked)


def _is_negated_of(condition: Condition, who: str, rule: Rule, subject: Subject) -> bool:
    if not isinstance(condition, InZone | Speed | Distance | Looks) or not without_none(condition).negate:
        return False
    names = (condition.entity,) if isinstance(condition.entity, str) else condition.entity
    if len(names) != 1 or (names[0] != who and not (names[0] == EACH and rule.for_each is not None)):
        return False
    # "Not on the field" is how who is off is asked for.
    return not (isinstance(condition, InZone) and _is_whole_field(condition, rule, subject))


def _is_whole_field(condition: InZone, rule: Rule, subject: Subject) -> bool:
    zones = [subject.scenario.zones[name] for name in subject.members(condition.zone, rule)]
    corners = floor_parts(subject.scenario.field)[0]
    return any(not zone.inverted and all(lies_in(corner, zone) for corner in corners) for zone in zones)


def _presence(rule: Rule, who: str, subject: Subject) -> str:
    entity = EACH if rule.for_each is not None and who in subject.members(EACH, rule) else who
    zone = _WHOLE_FIELD if _WHOLE_FIELD in subject.scenario.zones else "a zone over the whole field"
    return f"{{condition: in_zone, entity: {entity}, zone: {zone}}}"
