"""The trigger ``sequence_completed``."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import Binder, Phrases, Trigger
from rcj_challenges.rules.fields import Name, Names, described
from rcj_challenges.rules.refs import ENTITIES, SEQUENCE
from rcj_challenges.tracking.sequences import SequenceTracker


class SequenceTrigger(Trigger):
    """What triggers about a sequence share."""

    sequence: Annotated[Name, SEQUENCE] = described(..., "the sequence")
    entity: Annotated[Names | None, ENTITIES] = described(
        None,
        "for a sequence kept per entity: which entity; each: the current member; a group: any member; if omitted and "
        "there is no for_each: any of them",
    )

    MEASURED = "the time in s since the first step of the sequence"

    def trackers(self, to: Binder) -> tuple[SequenceTracker, ...]:
        """Return the trackers of the sequence: those of the entities that are named, else of all that have one."""
        trackers, owners = to.sequences(self.sequence), to.owners("sequences", self.sequence, self.entity)
        return tuple(trackers[member] for member in (trackers if owners is None else owners))

    def which(self, phrases: Phrases) -> str:
        """Return the sequence in words, with whose it is where each of several has one."""
        name, entity = self.sequence, self.entity
        if phrases.owners("sequence", name) is None:
            return phrases.kept("sequence", name, entity if isinstance(entity, str) else None)
        return phrases.owned("sequence", entity or phrases.one_of_owners("sequence", name) or (), name)

    def about(self, phrases: Phrases) -> Names | None:
        return self.entity or phrases.sequence_of(self.sequence)


class SequenceCompleted(SequenceTrigger):
    """Fires when the last step of a sequence is completed."""

    trigger: Literal["sequence_completed"]

    EXAMPLE = """
zones:
  west: {shape: rect, x_max_m: -0.3}
  middle: {shape: rect, x_min_m: -0.1, x_max_m: 0.1}
  east: {shape: rect, x_min_m: 0.3}
sequences:
  carry: {entity: ball, steps: [west, middle, east], wrong_step: break}
rules:
  done:
    triggers: [{trigger: sequence_completed, sequence: carry}]
    actions: [{action: emit, event: CARRIED}]
  wrong:
    triggers: [{trigger: sequence_broken, sequence: carry}]
    actions: [{action: emit, event: WRONG_WAY}]
expect:
  from_west_through_the_middle_to_east:
    keyframes:
      - {at_s: 1, place: {ball: [-0.4, 0]}}
      - {at_s: 3, move: {ball: [0.4, 0]}}
    lasts_s: 4
    events: [{event: CARRIED}]
  a_complete_sequence_does_not_break_before_its_first_step:
    keyframes:
      - {at_s: 1, place: {ball: [-0.4, 0]}}
      - {at_s: 3, move: {ball: [0.4, 0]}}
      - {at_s: 4, place: {ball: [0, 0]}}
      - {at_s: 5, place: {ball: [0.4, 0]}}
    lasts_s: 6
    events: [{event: CARRIED}]
  the_middle_must_not_be_skipped:
    keyframes:
      - {at_s: 1, place: {ball: [-0.4, 0]}}
      - {at_s: 2, place: {ball: [0.4, 0]}}
    lasts_s: 3
    events: [{event: WRONG_WAY}]
"""

    def bind(self, to: Binder) -> None:
        for tracker in self.trackers(to):
            tracker.completed.append(to.binding(tracker.entity))

    def describe(self, phrases: Phrases) -> str:
        return f"{self.which(phrases)} is complete"
