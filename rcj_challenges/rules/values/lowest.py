"""The value ``lowest``."""

from collections.abc import Sequence

from rcj_challenges.rules.base import Number
from rcj_challenges.rules.fields import described
from rcj_challenges.rules.values.folded import FoldedValue, Several


class LowestValue(FoldedValue):
    """The lowest of several numbers; none if there are none."""

    lowest: Several = described(..., "a value that names a group or others, read of each of them; or a list of numbers")

    KEY = "lowest"
    EXAMPLE = """
counters: {laps: {per: robots}}
rules:
  signal:
    for_each: robots
    triggers: [{trigger: time_reached, at_s: 2}]
    conditions:
      - {counter: laps, entity: each, at_most: {lowest: {counter: laps, entity: others}}}
    actions: [{action: emit, event: LAST, payload: {robot_name: {word: robot_name}}}]
expect:
  the_robot_with_the_fewest_laps_is_last:
    given: {counters: {laps: {B1: 2, B2: 2, B3: 2, Y1: 2, Y2: 1, Y3: 2}}}
    keyframes: [{at_s: 1}]
    lasts_s: 3
    events: [{event: LAST, payload: {robot_name: Y2}}]
"""
    SENTENCE = "the lowest counter “laps” of all others on the field"

    def fold(self, numbers: Sequence[Number]) -> Number | None:
        return min(numbers, default=None)
