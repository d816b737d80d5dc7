"""Whose way a sequence follows, and whose a trigger hears: of one entity, or of each of a group on its own."""

from __future__ import annotations

from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.models.state import Sequence
from rcj_challenges.scenario.models.triggers import SequenceBroken, SequenceCompleted


def followed(sequence: Sequence) -> str:
    """Return whose way a sequence follows: an entity, or the group of which each member has one of its own."""
    return sequence.per or sequence.entity or ""


def heard(trigger: SequenceCompleted | SequenceBroken, scenario: Scenario) -> str | tuple[str, ...]:
    """Return whose sequence a trigger hears, as the file names them: any of these."""
    return trigger.entity or followed(scenario.sequences[trigger.sequence])
