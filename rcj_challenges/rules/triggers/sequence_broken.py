"""The trigger ``sequence_broken``."""

from typing import Literal

from rcj_challenges.rules.base import Binder, Phrases
from rcj_challenges.rules.triggers.sequence_completed import SequenceCompleted, SequenceTrigger


class SequenceBroken(SequenceTrigger):
    """Fires on a wrong step in a sequence with ``wrong_step: break``; the sequence then starts again.

    Before the first step, none is wrong; afterwards all are but the last reached and the next.
    """

    trigger: Literal["sequence_broken"]

    EXAMPLE = SequenceCompleted.EXAMPLE

    def bind(self, to: Binder) -> None:
        for tracker in self.trackers(to):
            tracker.broken.append(to.binding(tracker.entity))

    def describe(self, phrases: Phrases) -> str:
        return f"{self.which(phrases)} is broken"
