"""Lint of rules that ask at a touch whether the ball lies still."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.lint_suspect import Subject, Suspect
from rcj_challenges.scenario.models.conditions import Speed
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.triggers import Touches

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
