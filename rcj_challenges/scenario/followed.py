"""Whose way a sequence follows, whose a trigger hears, and in which phases a sequence is followed."""

from __future__ import annotations

from rcj_challenges.rules.triggers.sequence_broken import SequenceBroken
from rcj_challenges.rules.triggers.sequence_completed import SequenceCompleted
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.models.state import Sequence
from rcj_challenges.scenario.walk import walk


def followed(sequence: Sequence) -> str:
    """Return whose way a sequence follows: an entity, or the group of which each member has one of its own."""
    return sequence.per or sequence.entity or ""


def heard(trigger: SequenceCompleted | SequenceBroken, scenario: Scenario) -> str | tuple[str, ...]:
    """Return whose sequence a trigger hears, as the file names them: any of these."""
    return trigger.entity or followed(scenario.sequences[trigger.sequence])


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
    """Return whether a rule hears or asks a sequence; one that only begins it anew does not follow it."""
    words = (word for word, _ in walk((rule.triggers, rule.conditions)))
    return any(getattr(word, "sequence", None) == name for word in words)
