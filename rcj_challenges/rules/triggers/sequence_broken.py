"""The trigger ``sequence_broken``."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import Binder, Phrases, Trigger
from rcj_challenges.rules.fields import Name, Names, described
from rcj_challenges.rules.refs import ENTITIES, SEQUENCE
from rcj_challenges.rules.triggers.sequence_completed import (
    WHOSE_SEQUENCE,
    SequenceCompleted,
    trackers_of,
    which_sequence,
)


class SequenceBroken(Trigger):
    """Fires on a wrong step in a sequence with ``wrong_step: break``; the sequence then starts again.

    Before the first step, none is wrong; afterwards all are but the last reached and the next.
    """

    trigger: Literal["sequence_broken"]
    sequence: Annotated[Name, SEQUENCE] = described(..., "the sequence")
    entity: Annotated[Names | None, ENTITIES] = described(None, WHOSE_SEQUENCE)

    MEASURED = "the time in s since the first step of the sequence"
    EXAMPLE = SequenceCompleted.EXAMPLE

    def bind(self, to: Binder) -> None:
        for tracker in trackers_of(to, self.sequence, self.entity):
            tracker.broken.append(to.binding(tracker.entity))

    def describe(self, phrases: Phrases) -> str:
        return f"{which_sequence(phrases, self.sequence, self.entity)} is broken"

    def about(self, phrases: Phrases) -> Names | None:
        return self.entity or phrases.sequence_of(self.sequence)
