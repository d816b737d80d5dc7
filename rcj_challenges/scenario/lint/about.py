"""Whom a rule can be about, and lint of events that are heard of what they are never about."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.followed import heard
from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.models import triggers
from rcj_challenges.scenario.models.actions import Emit
from rcj_challenges.scenario.models.conditions import AllOf, AnyOf, Condition, Distance, InZone, LastTouch, Looks, Speed
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.triggers import Trigger

OF_SEQUENCES = (triggers.SequenceCompleted, triggers.SequenceBroken)
_OF_ENTITY = (
    triggers.Enters,
    triggers.Leaves,
    triggers.Crosses,
    triggers.Touches,
    triggers.Displaced,
    triggers.NoProgress,
    triggers.StaysIn,
    triggers.TipsOver,
    triggers.Tells,
)


def check_heard_about(subject: Subject) -> Iterator[Suspect]:
    """Events that a rule hears of somebody or some place only, and that never are about that."""
    about: dict[str, set[str]] = {}
    for _, rule in subject.standing():
        for action in rule.actions:
            if isinstance(action, Emit):
                about.setdefault(action.event, set()).update(_events_about(rule, subject))
    in_order = (*subject.roster.things, *subject.scenario.zones, *subject.scenario.gates)
    for name, rule in subject.standing():
        for index, trigger in enumerate(rule.triggers):
            if not isinstance(trigger, triggers.OnEvent) or trigger.entity is None or trigger.event not in about:
                continue
            known = about[trigger.event]
            if known.isdisjoint(subject.members(trigger.entity, rule)):
                who = [one for one in in_order if one in known]
                is_about = f"is about {listing(who, 6)} only" if who else "is about nobody in particular"
                yield Suspect(
                    "rule_never_fires",
                    ("rules", name, "triggers", index, "entity"),
                    f"'{trigger.event}' {is_about}, as the rules that emit it are",
                    "give the rule that emits it a for_each over those that are meant, or leave entity out here",
                )


def _events_about(rule: Rule, subject: Subject) -> frozenset[str]:
    """Return what the events of a rule may be about: each thing that it is for, and nothing else.

    Of a rule for each of some zones or gates, or for none, it is what a trigger finds, and that zone or gate.
    """
    each = subject.members("each", rule) if rule.for_each is not None else frozenset()
    return each if each & {*subject.roster.things} else things_about(rule, subject) | each


def things_about(rule: Rule, subject: Subject) -> frozenset[str]:
    """Return the things that a firing may tell of: those of ``for_each``, and those that a trigger finds."""
    each = subject.members("each", rule) if rule.for_each is not None else frozenset()
    found = each.union(*(found_by(trigger, rule, subject) for trigger in rule.triggers))
    # Of a rule over zones or gates nobody is told but whom a trigger finds; of a gate's timer nobody is.
    return found & {*subject.roster.things}


def found_by(trigger: Trigger, rule: Rule, subject: Subject) -> frozenset[str]:
    """Return what a trigger tells of: whom it found, of a timer also the zone or gate that has it."""
    names: str | tuple[str, ...] = ()
    if isinstance(trigger, _OF_ENTITY):
        names = trigger.entity
    elif isinstance(trigger, triggers.ProgramFault):
        names = trigger.robot
    elif isinstance(trigger, triggers.OnEvent):
        names = trigger.entity or ()
    elif isinstance(trigger, OF_SEQUENCES):
        names = heard(trigger, subject.scenario)
    elif isinstance(trigger, triggers.TimerExpired):
        names = subject.scenario.timers[trigger.timer].per or ()
    elif isinstance(trigger, triggers.Holds):
        return _held(trigger.condition, rule, subject)
    return subject.members(names, rule)


def _held(condition: Condition, rule: Rule, subject: Subject) -> frozenset[str]:
    """Return the one entity whose place a condition reads; with several nobody knows which one it is about."""
    read = _read(condition, rule, subject)
    return frozenset(read) if len(read) == 1 else frozenset()


def _read(condition: Condition, rule: Rule, subject: Subject) -> list[str]:
    """Return the entities whose place a condition reads."""
    if isinstance(condition, AnyOf | AllOf):
        return list(dict.fromkeys(name for one in condition.conditions for name in _read(one, rule, subject)))
    if not isinstance(condition, InZone | Speed | Distance | Looks | LastTouch):
        return []
    other = condition.to if isinstance(condition, Distance) else None
    other = condition.towards if isinstance(condition, Looks) else other
    named = subject.members(other, rule) if isinstance(other, str) else ()
    gates = subject.scenario.gates
    moved_with = (gates[name].anchor if name in gates else name for name in named)
    others = {name for name in moved_with if name in subject.roster.entities and name is not None}
    return [*subject.members(condition.entity, rule), *others]
