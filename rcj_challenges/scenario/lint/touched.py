"""Lint of rules that ask for what is gone by then: whether a touched ball lies still, who touched last one put anew."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.catalogue import EACH
from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.models.actions import Emit, LastToucher, Place
from rcj_challenges.scenario.models.conditions import LastTouch, Speed
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.state import LastTouchValue
from rcj_challenges.scenario.models.triggers import OnEvent, Touches
from rcj_challenges.scenario.roster import row_of

_STILL_MPS = 0.05
"""Who asks for less means a ball that lies still; a touch makes it faster."""


def check_touched(subject: Subject) -> Iterator[Suspect]:
    """Conditions that a ball lies still in the very tick in which something touches it."""
    for name, rule in subject.scenario.rules.items():
        touched = _touched(rule, subject)
        for index, condition in enumerate(rule.conditions):
            if isinstance(condition, Speed) and _asks_for_rest(condition):
                balls = subject.members(condition.entity, rule) & touched
                if balls:
                    yield Suspect(
                        "still_when_touched",
                        ("rules", name, "conditions", index),
                        f"in the tick in which it is touched '{min(balls)}' rolls already: this holds only after a "
                        "touch that hardly moved it, though tests, which have no physics, pass",
                        "let a flag remember that it lay still, set by holds of its speed",
                    )


def check_touching_itself(subject: Subject) -> Iterator[Suspect]:
    """Touches of groups in which one thing alone is left: it does not touch itself."""
    for name, rule in subject.scenario.rules.items():
        in_vain = "the rule" if len(rule.triggers) == 1 else "this trigger"
        for index, trigger in enumerate(rule.triggers):
            if not isinstance(trigger, Touches):
                continue
            who = subject.members(trigger.entity, rule)
            if len(who) == 1 and who == subject.members(trigger.other, rule):
                yield Suspect(
                    "rule_never_fires",
                    ("rules", name, "triggers", index),
                    f"'{min(who)}' alone is meant on both sides, and nothing touches itself",
                    f"take {in_vain} out, or name in other what else it touches",
                )


def check_last_touches(subject: Subject) -> Iterator[Suspect]:
    """Conditions on who touched something last, in the very tick in which somebody else touches it."""
    for name, rule in subject.scenario.rules.items():
        # For each member: `each` is the same one in a trigger and in a condition.
        members = sorted(subject.members(EACH, rule)) if rule.for_each is not None else [None]
        rules = [rule if one is None else rule.model_copy(update={"for_each": one}) for one in members]
        for index, condition in enumerate(rule.conditions):
            if not isinstance(condition, LastTouch):
                continue
            if rules and all(_is_of_another_touch(condition, one, subject) for one in rules):
                yield Suspect(
                    "last_touch_is_this_touch",
                    ("rules", name, "conditions", index),
                    "in the tick in which it is touched, who touches it is the one who touched it last: this holds "
                    "only where both touch it in the same tick",
                    "let a flag remember who has touched it: a rule of that touch sets it, and this one asks it",
                )


def check_forgotten_touches(subject: Subject) -> Iterator[Suspect]:
    """Who touched last what was put elsewhere in the tick before, by whatever has emitted the event that is heard."""
    for model, path in subject.models:
        if path[:1] != ("rules",) or not isinstance(model, LastTouch | LastToucher | LastTouchValue):
            continue
        rule = subject.scenario.rules[str(path[1])]
        what = model.entity if isinstance(model, LastTouch) else model.last_touch
        emitters = _emitters(rule, subject) if what != EACH else []  # `each` of one rule is another one in the other
        if emitters and all(what in _surely_put(subject.scenario.rules[name], subject) for name in emitters):
            yield Suspect(
                "last_touch_forgotten",
                path,
                f"the rule '{emitters[0]}', whose event is heard one tick later, has put '{what}' elsewhere by then: "
                "nobody has touched it since",
                f"ask in '{emitters[0]}' itself, where it is known still, or let that rule set a flag or a counter",
            )


def _emitters(rule: Rule, subject: Subject) -> list[str]:
    """Return the rules whose events alone set a rule off; none: something else does too."""
    heard = {trigger.event for trigger in rule.triggers if isinstance(trigger, OnEvent)}
    if not all(isinstance(trigger, OnEvent) for trigger in rule.triggers):
        return []
    return [
        name
        for name, one in subject.standing()
        if any(isinstance(action, Emit) and action.event in heard for action in one.actions)
    ]


def _surely_put(rule: Rule, subject: Subject) -> frozenset[str]:
    """Return what a rule puts somewhere, whichever way chance decides."""
    found: set[str] = set()
    for action in rule.actions:
        if isinstance(action, Place) and action.entity is not None:
            found |= subject.surely(action.entity, rule) if rule.for_each is None else set(row_of(action.entity))
        elif isinstance(action, Place) and isinstance(action.layout, str):
            for placing in subject.scenario.placements.get(action.layout, ()):
                found |= subject.surely(placing.entity, rule)
    return frozenset(found)


def _is_of_another_touch(condition: LastTouch, rule: Rule, subject: Subject) -> bool:
    touching: set[str] = set()
    touched = subject.members(condition.entity, rule)
    for trigger in rule.triggers:
        if not isinstance(trigger, Touches) or len(touched) != 1:
            return False
        one, other = subject.members(trigger.entity, rule), subject.members(trigger.other, rule)
        if touched not in (one, other):
            return False
        touching |= other if one == touched else one
    if not touching or touching - subject.scenario.robots.keys():
        return False  # at the touch of a wall or a crate it is the robot before
    by = subject.members(condition.by, rule)
    return touching <= by if condition.negate else not touching & by


def _touched(rule: Rule, subject: Subject) -> frozenset[str]:
    """Return the balls whose touch sets a rule off, if nothing else does."""
    found: set[str] = set()
    for trigger in rule.triggers:
        if not isinstance(trigger, Touches) or trigger.every_s is not None:
            return frozenset()
        found |= subject.members(trigger.entity, rule) | subject.members(trigger.other, rule)
    return frozenset(found & subject.scenario.balls.keys())


def _asks_for_rest(condition: Speed) -> bool:
    bounds = (condition.at_least,) if condition.negate else (condition.at_most, condition.equals)
    return any(isinstance(bound, int | float) and bound <= _STILL_MPS for bound in bounds)
