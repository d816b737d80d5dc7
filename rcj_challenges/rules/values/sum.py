"""The value ``sum``."""

from collections.abc import Sequence

from rcj_challenges.core.amounts import clamp_to_max
from rcj_challenges.rules.base import Number, Phrases
from rcj_challenges.rules.fields import described
from rcj_challenges.rules.number import Term, amount_words, terms_of
from rcj_challenges.rules.values.folded import FoldedValue, Several


class SumValue(FoldedValue):
    """The sum of several numbers, which passes over none; 0 if there are none."""

    sum: Several = described(..., "a value that names a group or others, read of each of them; or a list of numbers")

    KEY = "sum"
    EXAMPLE = """
counters: {hits: {}}
flags: {blue_corner: {}, yellow_corner: {initial: true}}
rules:
  hit:
    triggers: [{trigger: touches, entity: Y1, other: ball}]
    actions: [{action: count, counter: hits}]
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    # A point for each touch, and 3 for each corner that has been visited.
    actions:
      - action: score
        entrant: yellow
        points: {sum: [{counter: hits}, {flag: blue_corner, times: 3}, {flag: yellow_corner, times: 3}]}
expect:
  two_touches_and_a_corner_give_five_points:
    keyframes:
      - {at_s: 1, touch: [[Y1, ball]]}
      - {at_s: 2, touch: [[Y1, ball]]}
      - {at_s: 3, place: {ball: [0, 0.8]}}
    lasts_s: 4
    score: {yellow: 5}
"""

    def fold(self, numbers: Sequence[Number]) -> Number:
        total: Number = 0
        for one in numbers:  # from left to right, so that the last bit is the same in every Python
            total += clamp_to_max(one)  # each of them: ∞ - ∞ would be no number
        return total

    def describe(self, phrases: Phrases) -> str:
        return amount_words(phrases, self.alone()) if isinstance(self.sum, tuple) else super().describe(phrases)

    def terms(self) -> tuple[Term, ...]:
        if self.is_computed() or not isinstance(self.sum, tuple):
            return super().terms()
        return tuple(term for one in self.sum for term in terms_of(one))
