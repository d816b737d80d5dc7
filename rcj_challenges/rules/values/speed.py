"""The value ``speed``."""

from typing import Annotated

from rcj_challenges.rules.base import Phrases, Reader, Scope
from rcj_challenges.rules.fields import MM_DIGITS, Names, described
from rcj_challenges.rules.number import NumberValue
from rcj_challenges.rules.phrasing import Clause
from rcj_challenges.rules.refs import ENTITY


class SpeedValue(NumberValue):
    """The speed of an entity's centre in m/s, to the mm/s; none off the field, and in a tick in which it was put there.

    It is the path in the last tick divided by its duration.
    """

    speed: Annotated[Names, ENTITY] = described(
        ..., "an entity, or each; in highest, lowest and sum also a group or others"
    )

    KEY = "speed"
    UNIT = "m/s"
    OVER = "speed"
    DIGITS = MM_DIGITS
    EXAMPLE = """
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    # The faster the ball, the more points: one for each 0.1 m/s, if it has at least 0.3 m/s.
    conditions: [{speed: ball, at_least: 0.3}]
    actions: [{action: score, entrant: yellow, points: {speed: ball, times: 10, round: down}}]
expect:
  half_a_metre_in_a_second_gives_five_points:
    keyframes: [{at_s: 1, place: {ball: [0, 0.3]}}, {at_s: 2, move: {ball: [0, 0.82]}}]
    lasts_s: 3
    score: {yellow: 5}
  a_slow_one_gives_none:
    keyframes: [{at_s: 1, place: {ball: [0, 0.7]}}, {at_s: 2, move: {ball: [0, 0.8]}}]
    lasts_s: 3
    score: {yellow: 0}
"""

    def measure(self, to: Scope) -> Reader:
        state, entity = to.state, to.entities(self.speed)[0]
        return lambda _firing: state.speed_mps(entity)

    def places(self, to: Scope) -> tuple[int, ...]:
        return to.entities(self.speed)

    def describe(self, phrases: Phrases) -> str:
        return f"{phrases.owned('speed', self.speed)} in {self.UNIT}"

    def about(self) -> Names:
        return self.speed

    def clause(self, _phrases: Phrases) -> Clause:
        return Clause(self.speed, "moves", "move", "at a speed of {}", " m/s", or_off=" or is off the field")
