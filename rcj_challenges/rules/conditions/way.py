"""The condition ``way``."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import Binder, Phrases, Test
from rcj_challenges.rules.comparison import Compared, to_mm
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.quantifier import Quantifier, quantified
from rcj_challenges.rules.refs import ENTITIES


class WayIs(Compared):
    """The length of an entity's path in this half in m, not counting placements; also for entities off the field."""

    condition: Literal["way"]
    entity: Annotated[Names, ENTITIES] = described(..., "an entity, each, or a group with `of`")
    of: Quantifier = described("any", "how many members of a group must satisfy it")

    EXAMPLE = """
counters: {budget_m: {initial: 1}}
rules:
  used_up:
    for_each: yellow
    triggers: [{trigger: holds, condition: {condition: way, entity: each, at_least: {counter: budget_m}}}]
    actions: [{action: remove, entity: each}, {action: emit, event: USED_UP, payload: {robot_name: {word: robot_name}}}]
  put_back:
    # A placement by a rule does not count, and does not restore the budget.
    triggers: [{trigger: time_reached, at_s: 3}]
    actions: [{action: place, entity: Y1, at: {point: [0.5, -0.5]}}]
expect:
  after_a_metre_it_is_off:
    keyframes:
      - {at_s: 1, place: {Y1: [0, -0.6], Y2: [-0.3, -0.3], Y3: [-0.3, -0.6]}}
      - {at_s: 2, move: {Y1: [0, 0]}}
      - {at_s: 4}
      - {at_s: 5, move: {Y1: [0.5, 0.5]}}
    lasts_s: 6
    events: [{event: USED_UP, payload: {robot_name: Y1}}]
"""
    SENTENCE = "it has a way in this half of at least as many m as the counter “budget (m)” says"

    def test(self, to: Binder) -> Test:
        state, of = to.state, self.of
        entities, holds = to.entities(self.entity), self.comparison(to, counted=to_mm)
        for entity in entities:
            state.follow_way(entity)
        return lambda: quantified(of, (holds(state.ways[entity]) for entity in entities))

    def describe(self, phrases: Phrases) -> str:
        subject = phrases.quantified(self.of, self.entity, negate=self.negate)
        if subject.negated and (opposite := self.opposite(phrases, " m")):
            return f"{subject.text} has a way in this half of {opposite}"
        return f"{subject.does('has', 'have')} a way in this half of {self.compared(phrases, ' m')}"
