"""The condition ``sequence``."""

from typing import Annotated

from rcj_challenges.rules.base import Binder, Condition, Phrases, Test
from rcj_challenges.rules.fields import Name, Names, described
from rcj_challenges.rules.kept import asked, kept, test_of_kept
from rcj_challenges.rules.phrasing import quoted
from rcj_challenges.rules.quantifier import Quantifier
from rcj_challenges.rules.refs import ENTITIES, SEQUENCE, Ref


class SequenceIs(Condition):
    """Which step a sequence has reached."""

    sequence: Annotated[Name, SEQUENCE] = described(..., "a sequence")
    entity: Annotated[Names | None, ENTITIES] = described(
        None,
        "for a sequence kept per entity: which entity, a group or a list; each: the current member; if omitted and "
        "there is no for_each: any of them",
    )
    of: Quantifier | None = described(
        None, "how many members of a group must be at that step; without entity: of all members"
    )
    equals: Annotated[Name, Ref("zone or gate", frozenset({"zone", "gate"}), each=True)] = described(
        ..., "the zone or gate reached last, or each"
    )

    KEY = "sequence"
    EXAMPLE = """
zones:
  west: {shape: rect, x_max_m: -0.3}
  east: {shape: rect, x_min_m: 0.3}
sequences:
  across: {per: yellow, steps: [west, east]}
rules:
  two_are_on_their_way:
    triggers: [{trigger: touches, entity: robots, other: ball}]
    # `of` sets how many must be at that step; `entity: Y1` would test Y1 alone.
    conditions: [{sequence: across, equals: west, of: {at_least: 2}}]
    actions: [{action: score, entrant: yellow}]
expect:
  with_only_one_on_its_way_a_touch_gives_nothing:
    keyframes:
      - {at_s: 1, place: {Y1: [-0.5, 0]}}
      - {at_s: 2, touch: [[Y1, ball]]}
      - {at_s: 3, place: {Y2: [-0.5, -0.3]}}
      - {at_s: 4, touch: [[B1, ball]]}
    lasts_s: 5
    score: {yellow: 1}
"""
    SENTENCE = "at least 2 of the yellow robots have a sequence “across” that stands at the west"

    def test(self, to: Binder) -> Test:
        trackers = to.sequences(self.sequence)
        everyone = tuple(trackers.values())
        (step,) = to.members(self.equals)

        def test(whose: str | None) -> bool:
            asked = everyone if whose is None else (trackers[whose],)
            return any(tracker.reached == step for tracker in asked)

        return test_of_kept(self, to, "sequences", self.sequence, trackers, test)

    def describe(self, phrases: Phrases) -> str:
        subject, step = asked(phrases, self, "sequence", self.sequence), phrases.thing(self.equals)
        if subject is not None:
            return f"{subject.does('has', 'have')} a sequence {quoted(self.sequence)} that stands at {step}"
        stands = "does not stand" if self.negate else "stands"
        return f"{kept(phrases, self, 'sequence', self.sequence)} {stands} at {step}"
