"""A condition that the package does not have."""

from typing import Annotated

from rcj_challenges.rules.base import Binder, Condition, Phrases, Test
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.phrasing import metres
from rcj_challenges.rules.refs import ENTITY


class RightOf(Condition):
    """Whether an entity is further to the right than a line along the field."""

    right_of: float = described(..., "x of the line in m")
    beside: Annotated[Name, ENTITY] = described(..., "which")

    KEY = "right_of"
    EXAMPLE = """
rules:
  goal_from_the_right:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    conditions: [{right_of: 0.05, beside: ball}]
    actions: [{action: score, entrant: yellow}]
expect:
  only_the_second_one_counts:
    keyframes:
      - {at_s: 1, place: {ball: [0, 0.8]}}
      - {at_s: 2, place: {ball: [0, 0]}}
      - {at_s: 3, place: {ball: [0.1, 0.8]}}
    lasts_s: 4
    score: {yellow: 1}
"""

    def test(self, to: Binder) -> Test:
        """Return whether the entity is to the right of the line."""
        state, entity, x_m = to.state, to.entities(self.beside)[0], self.right_of
        return lambda: state.poses[entity][0] > x_m

    def describe(self, phrases: Phrases) -> str:
        """Return the part of a sentence that follows ``if``."""
        return f"{phrases.thing(self.beside)} is {'not ' * self.negate}more than {metres(self.right_of)} to the right"
