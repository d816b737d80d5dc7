"""The value ``way``."""

from typing import Annotated

from rcj_challenges.rules.base import Phrases, Reader, Scope
from rcj_challenges.rules.fields import MM_DIGITS, Names, described
from rcj_challenges.rules.number import NumberValue
from rcj_challenges.rules.phrasing import Clause
from rcj_challenges.rules.refs import ENTITY


class WayValue(NumberValue):
    """The length of an entity's path in this half in m, to the millimetre, not counting placements.

    Where rules put it is no way. Since a moment: this less a counter that was set to it then.
    """

    way: Annotated[Names, ENTITY] = described(
        ..., "an entity, or each; in highest, lowest and sum also a group or others"
    )

    KEY = "way"
    OVER = "way"
    DIGITS = MM_DIGITS
    UNIT = "m"
    EXAMPLE = """
counters: {way_before_m: {}}
rules:
  taken:
    triggers: [{trigger: touches, entity: Y1, other: ball}]
    max_executions: 1
    actions: [{action: count, counter: way_before_m, to: {way: ball}}]
  brought:
    triggers: [{trigger: stays_in, entity: ball, zone: blue_goal, limit_s: 0.5}]
    # 10 points, less 2 for each metre that the ball has travelled since it was taken; none if it was carried for 5 m.
    conditions: [{way: ball, below: 5}]
    actions:
      - action: score
        entrant: yellow
        points: {way: ball, times: -2, plus: {counter: way_before_m, times: 2, plus: 10}}
      - {action: emit, event: BROUGHT, payload: {in_all_m: {way: ball}}}
    says: The ball has been delivered; {points} points.
expect:
  a_metre_costs_2_points:
    keyframes:
      - {at_s: 1, place: {ball: [0, -0.2]}}
      - {at_s: 2, touch: [[Y1, ball]]}
      - {at_s: 4, move: {ball: [0, 0.8]}}
    lasts_s: 5
    score: {yellow: 8}
    events: [{event: BROUGHT, payload: {in_all_m: 1.2}}]
"""

    def measure(self, to: Scope) -> Reader:
        ways, entity = to.state.ways, to.entities(self.way)[0]
        ways.setdefault(entity, 0.0)
        return lambda _firing: ways[entity]

    def describe(self, phrases: Phrases) -> str:
        return f"{phrases.owned('way', self.way)} in this {phrases.period} in {self.UNIT}"

    def clause(self, phrases: Phrases) -> Clause:
        return Clause(self.way, "has", "have", f"a way in this {phrases.period} of {{}}", " m")
