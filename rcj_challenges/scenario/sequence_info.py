"""What a sequence follows, and in which phases."""

from __future__ import annotations

from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.models.state import Sequence
from rcj_challenges.scenario.walk import walk


def followed(sequence: Sequence) -> str:
    """Return what a sequence follows: an entity, or the group of which each member has a sequence of its own."""
    return sequence.per or sequence.entity or ""


def phases_of(scenario: Scenario, name: str) -> frozenset[str] | None:
    """Return the phases in which a sequence is followed: those of the rules that name it; None: all of them."""
    phases: set[str] = set()
    for rule in scenario.rules.values():
        if not _follows(rule, name):
            continue
        if rule.phases == "any":
            return None
        phases.update(rule.phases)
    return frozenset(phases)


def _follows(rule: Rule, name: str) -> bool:
    """Return whether a rule is triggered by a sequence or reads it; a rule that only resets it does not follow it."""
    words = (word for word, _ in walk((rule.triggers, rule.conditions)))
    return any(getattr(word, "sequence", None) == name for word in words)
