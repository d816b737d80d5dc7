"""What is particular to the condition ``way``."""

from rcj_challenges.rules.base import Phrases
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.values.way import WayValue


class WayIs(Compared, WayValue):
    """The length of an entity's path in this half in m, not counting placements; also for entities off the field."""

    VALUE = WayValue
    EXAMPLE = """
counters: {budget_m: {initial: 1}}
rules:
  used_up:
    for_each: yellow
    triggers: [{trigger: holds, conditions: [{way: each, at_least: {counter: budget_m}}]}]
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

    def describe(self, phrases: Phrases) -> str:
        if self.value.is_computed():
            return super().describe(phrases)
        subject = phrases.quantified(self.of or "any", self.way, negate=self.negate)
        if subject.negated and (opposite := self.opposite(phrases, " m")):
            return f"{subject.text} has a way in this {phrases.period} of {opposite}"
        return f"{subject.does('has', 'have')} a way in this {phrases.period} of {self.compared(phrases, ' m')}"
