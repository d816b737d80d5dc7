"""Lint of who is off the field and meant by a rule all the same: "not in the zone" is true of what is nowhere."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.catalogue import EACH
from rcj_challenges.scenario.floor import floor_parts
from rcj_challenges.scenario.floor_shapes import lies_in
from rcj_challenges.scenario.lint.logic import Way, ways_to_hold, without_none
from rcj_challenges.scenario.lint.suspect import Subject, Suspect, lengths_s
from rcj_challenges.scenario.models.actions import Count, Emit, End, Remove, Score, SetPhase, TimerAction
from rcj_challenges.scenario.models.conditions import Condition, Distance, HalfIs, InZone, Looks, Speed
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.triggers import Holds, OnEvent, PhaseEntered, TimeReached, TimerExpired, Trigger
from rcj_challenges.scenario.roster import row_of

_WHOLE_FIELD = "pitch"
_FOR_EVER = float("inf")


def check_gone(subject: Subject) -> Iterator[Suspect]:
    """Rules that put back, give points for or take off anew who is off the field, for what is negated is true of it."""
    for name, rule in subject.standing():
        yield from _own_removals(name, rule, subject)
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


def _own_removals(name: str, rule: Rule, subject: Subject) -> Iterator[Suspect]:
    """Yield what a rule goes on announcing of those that it has taken off the field itself."""
    once = rule.max_executions is not None or any(isinstance(one, End | SetPhase) for one in rule.actions)
    if once or not any(isinstance(one, Score | Count | Emit) for one in rule.actions):
        return
    removals = [one for one in rule.actions if isinstance(one, Remove)]
    for index, trigger in enumerate(rule.triggers):
        patience_s = _patience_s(trigger)
        if patience_s is None or not _comes_again(trigger, subject):
            continue
        asked = (trigger.condition,) if isinstance(trigger, Holds) else ()
        for who in sorted({who for one in removals for who in subject.members(one.entity, rule)} - subject.put(rule)):
            away_s = max(_away_s(one, subject) for one in removals if who in subject.members(one.entity, rule))
            if away_s > patience_s and _means(who, (*asked, *rule.conditions), rule, subject):
                yield Suspect(
                    "meant_off_the_field",
                    ("rules", name, "triggers", index),
                    f"what it asks is true of '{who}' also while this rule itself has taken it off the field, "
                    "for it is nowhere then: it fires for it again and again",
                    f"add what is true on the field only to its conditions: {_presence(rule, who, subject)}",
                )
                break


def _comes_again(trigger: Trigger, subject: Subject) -> bool:
    """Return whether a moment surely comes more than once for who stays off the field."""
    if isinstance(trigger, TimerExpired):
        actions = (action for _, rule in subject.standing() for action in rule.actions)
        return any(isinstance(one, TimerAction) and one.timer == trigger.timer for one in actions)
    # Being taken off once more begins the time of what holds anew.
    return isinstance(trigger, Holds) or (isinstance(trigger, TimeReached) and trigger.every_s is not None)


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
            away_s = _away_s(action, subject)
            for who in sorted(subject.members(action.entity, rule)):
                if away_s > found.get(who, ("", 0.0))[1]:
                    found[who] = (name, away_s)
    return found


def _away_s(action: Remove, subject: Subject) -> float:
    """Return how long a removal keeps something off the field, in s."""
    if action.for_s is None:
        return _FOR_EVER
    return max(lengths_s(action.for_s, subject.scenario), default=_FOR_EVER)


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
    names = row_of(condition.entity)
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
