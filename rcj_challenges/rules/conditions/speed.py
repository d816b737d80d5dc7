"""The condition ``speed``."""

from math import sqrt
from typing import Annotated, Literal

from rcj_challenges.core.timing import TICK_S
from rcj_challenges.rules.base import Binder, Phrases, Test
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.quantifier import Quantifier, quantified
from rcj_challenges.rules.refs import ENTITIES


class Speed(Compared):
    """The speed of an entity's centre in m/s (path in the last tick divided by its duration)."""

    condition: Literal["speed"]
    entity: Annotated[Names, ENTITIES] = described(..., "an entity, each, or a group with `of`")
    of: Quantifier = described("any", "how many members of a group must satisfy it")

    ABOUT = "entity"
    EXAMPLE = """
rules:
  hard_shot:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    conditions: [{condition: speed, entity: ball, at_least: 0.3}]
    actions: [{action: emit, event: HARD_SHOT}]
expect:
  half_a_metre_in_a_second_is_hard:
    keyframes:
      - {at_s: 1, place: {ball: [0, 0.3]}}
      - {at_s: 2, move: {ball: [0, 0.8]}}
    lasts_s: 3
    events: [{event: HARD_SHOT}]
  a_tenth_is_not:
    keyframes:
      - {at_s: 1, place: {ball: [0, 0.7]}}
      - {at_s: 2, move: {ball: [0, 0.8]}}
    lasts_s: 3
    events: []
"""
    SENTENCE = "the ball moves at a speed of at least 0.3 m/s"

    def test(self, to: Binder) -> Test:
        state, of = to.state, self.of
        entities, holds = to.entities(self.entity), self.comparison(to)

        def mps(entity: int) -> float:
            (x, y, _), (was_x, was_y, _) = state.poses[entity], state.before[entity]
            return sqrt((x - was_x) ** 2 + (y - was_y) ** 2) / TICK_S

        def compares(entity: int) -> bool:
            # What jumps, by hand in a test, is neither fast nor at rest.
            return entity not in state.by_hand and holds(mps(entity))

        return lambda: quantified(of, (compares(entity) for entity in entities if state.present[entity]))

    def describe(self, phrases: Phrases) -> str:
        subject = phrases.quantified(self.of, self.entity, negate=self.negate)
        opposite = self.opposite(phrases, " m/s") if subject.negated else None
        if opposite is None:
            return f"{subject.does('moves', 'move')} at a speed of {self.compared(phrases, ' m/s')}"
        off = " or is off the field" if phrases.may_be_off() else ""
        return f"{subject.text} moves at a speed of {opposite}{off}"
