"""What is particular to the condition ``speed``."""

from rcj_challenges.rules.base import Phrases
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.values.speed import SpeedValue


class SpeedIs(Compared, SpeedValue):
    """The speed of an entity's centre in m/s (path in the last tick divided by its duration)."""

    VALUE = SpeedValue
    ABOUT = "speed"
    EXAMPLE = """
rules:
  hard_shot:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    conditions: [{speed: ball, at_least: 0.3}]
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

    def describe(self, phrases: Phrases) -> str:
        if self.value.is_computed():
            return super().describe(phrases)
        subject = phrases.quantified(self.of or "any", self.speed, negate=self.negate)
        opposite = self.opposite(phrases, " m/s") if subject.negated else None
        if opposite is None:
            return f"{subject.does('moves', 'move')} at a speed of {self.compared(phrases, ' m/s')}"
        off = " or is off the field" if phrases.may_be_off() else ""
        return f"{subject.text} moves at a speed of {opposite}{off}"
