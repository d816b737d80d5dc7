"""The condition ``in_zone``."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import Binder, Condition, Phrases, Test
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.quantifier import Quantifier, quantified
from rcj_challenges.rules.refs import ENTITIES, ZONES


class InZone(Condition):
    """Whether an entity's centre is in a zone; an entity off the field is in no zone."""

    condition: Literal["in_zone"]
    entity: Annotated[Names, ENTITIES] = described(..., "an entity, each, or a group with `of`")
    zone: Annotated[Names, ZONES] = described(
        ..., "a zone, each, or a draw's name; with a list or group: in any of them"
    )
    of: Quantifier = described("any", "how many members of a group must be in it")

    ABOUT = "entity"
    ASKS_WHERE = True
    EXAMPLE = """
rules:
  crowd:
    triggers: [{trigger: time_reached, at_s: 2}]
    conditions: [{condition: in_zone, entity: yellow, zone: blue_penalty_area, of: {at_least: 2}}]
    actions: [{action: emit, event: CROWD}]
expect:
  two_of_three_are_a_crowd:
    keyframes: [{at_s: 1, place: {Y1: [-0.2, 0.65], Y2: [0.2, 0.65]}}]
    lasts_s: 3
    events: [{event: CROWD}]
"""
    SENTENCE = "at least 2 of the yellow robots are in the blue penalty area"

    def test(self, to: Binder) -> Test:
        state, of = to.state, self.of
        entities, region = to.entities(self.entity), to.region(self.zone)

        def test() -> bool:
            poses = state.poses
            return quantified(of, (region.contains(poses[e][0], poses[e][1]) for e in entities if state.present[e]))

        return test

    def describe(self, phrases: Phrases) -> str:
        subject = phrases.quantified(self.of, self.entity, negate=self.negate)
        return f"{subject.does('is', 'are')} in {phrases.any_of(self.zone)}"
