"""A value that the package does not have; it is a number too."""

from typing import Annotated

from rcj_challenges.rules.base import Phrases, Reader, Scope
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.number import NumberValue
from rcj_challenges.rules.refs import ENTITY


class YOf(NumberValue):
    """How far up the field an entity is, in m."""

    y_of: Annotated[Name, ENTITY] = described(..., "which")

    KEY = "y_of"
    UNIT = "m"
    EXAMPLE = """
rules:
  late:
    triggers: [{trigger: time_reached, at_s: 2}]
    actions:
      - {action: score, entrant: yellow, points: {y_of: ball, times: 10, plus: 1}}
      - {action: emit, event: LATE, payload: {y_m: {y_of: ball}}}
expect:
  half_a_metre_gives_six_points:
    keyframes: [{at_s: 1, place: {ball: [0, 0.5]}}]
    lasts_s: 3
    score: {yellow: 6}
    events: [{event: LATE, payload: {y_m: 0.5}}]
"""

    def measure(self, to: Scope) -> Reader:
        """Return what reads how far up it is."""
        state, entity = to.state, to.entities(self.y_of)[0]
        return lambda _firing: state.poses[entity][1]

    def describe(self, phrases: Phrases) -> str:
        """Return the value in words."""
        return f"the y of {phrases.thing(self.y_of)} in {self.UNIT}"
