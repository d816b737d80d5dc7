"""The action ``sequence``."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import Act, Action, Binder, Firing, Phrases
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.refs import ENTITY, WRITTEN_SEQUENCE


class SequenceAction(Action):
    """Restart a sequence: its completed steps are lost."""

    action: Literal["sequence"]
    sequence: Annotated[Name, WRITTEN_SEQUENCE] = described(..., "the sequence")
    entity: Annotated[Name | None, ENTITY] = described(
        None, "for a sequence kept per entity: which entity, or each; if omitted: all of them"
    )
    do: Literal["reset"] = described(
        "reset", "reset: back to before the first step, or to the first step if the entity is there"
    )

    EXAMPLE = """
zones:
  west: {shape: rect, x_max_m: -0.3}
  east: {shape: rect, x_min_m: 0.3}
sequences:
  across: {entity: ball, steps: [west, east]}
rules:
  touched_by_blue:
    triggers: [{trigger: touches, entity: blue, other: ball}]
    actions: [{action: sequence, sequence: across, do: reset}]
  across:
    triggers: [{trigger: sequence_completed, sequence: across}]
    actions: [{action: score, entrant: yellow}]
expect:
  a_touch_by_blue_undoes_the_first_step:
    keyframes:
      - {at_s: 1, place: {ball: [-0.5, 0]}}
      - {at_s: 2, place: {ball: [0, 0]}, touch: [[B1, ball]]}
      - {at_s: 3, place: {ball: [0.5, 0]}}
    lasts_s: 4
    score: {yellow: 0}
"""
    SENTENCE = "the sequence “across” starts again"

    def compile(self, to: Binder) -> Act:
        trackers, whose = to.sequences(self.sequence), to.whose(self.entity)
        chosen = tuple(trackers.values()) if whose is None else (trackers[whose],)

        def act(_firing: Firing) -> None:
            for tracker in chosen:
                to.reset(tracker)

        return act

    def describe(self, phrases: Phrases) -> str:
        return f"{phrases.every_kept('sequence', self.sequence, self.entity)} starts again"
