"""The condition ``sequence``."""

from typing import Annotated

from rcj_challenges.rules.base import Binder, Condition, Phrases, Test
from rcj_challenges.rules.fields import Name, Names, described
from rcj_challenges.rules.phrasing import quoted
from rcj_challenges.rules.quantifier import Quantifier, quantified
from rcj_challenges.rules.refs import ENTITIES, SEQUENCE, Ref
from rcj_challenges.rules.values.kept import owners_asked


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

    def test(self, to: Binder) -> Test:
        trackers, of, (step,) = to.sequences(self.sequence), self.of, to.members(self.equals)
        if of is None and self.entity is None:
            owners = to.owners("sequences", self.sequence, None)
            read = tuple(trackers[one] for one in (trackers if owners is None else owners))
            return lambda: any(tracker.reached == step for tracker in read)
        _, members_now = to.group_of_owners("sequences", self.sequence, self.entity or tuple(filter(None, trackers)))
        return lambda: quantified(of or "any", (trackers[member].reached == step for member in members_now()))

    def describe(self, phrases: Phrases) -> str:
        entity, step = self.entity, phrases.thing(self.equals)
        subject = owners_asked(phrases, "sequence", self.sequence, entity, self.of, negate=self.negate)
        if subject is not None:
            return f"{subject.does('has', 'have')} a sequence {quoted(self.sequence)} that stands at {step}"
        sequence = phrases.kept("sequence", self.sequence, entity if isinstance(entity, str) else None)
        return f"{sequence} {'does not stand' if self.negate else 'stands'} at {step}"
