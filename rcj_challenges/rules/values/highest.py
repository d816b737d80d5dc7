"""The value ``highest``."""

from collections.abc import Sequence

from rcj_challenges.rules.base import Number
from rcj_challenges.rules.fields import described
from rcj_challenges.rules.values.folded import FoldedValue, Several


class HighestValue(FoldedValue):
    """The highest of several numbers; none if there are none."""

    highest: Several = described(
        ..., "a value that names a group or others, read of each of them; or a list of numbers"
    )

    KEY = "highest"
    EXAMPLE = """
counters: {laps: {per: robots}}
rules:
  most:
    for_each: robots
    triggers: [{trigger: time_reached, at_s: 2}]
    conditions: [{counter: laps, entity: each, at_least: {highest: {counter: laps, entity: others}}}]
    actions: [{action: emit, event: FIRST, payload: {robot_name: {word: robot_name}}}]
  # If several tie for last, all of them are.
  fewest:
    for_each: robots
    triggers: [{trigger: time_reached, at_s: 2}]
    conditions: [{counter: laps, entity: each, at_most: {lowest: {counter: laps, entity: others}}}]
    actions: [{action: emit, event: LAST, payload: {robot_name: {word: robot_name}}}]
expect:
  the_most_laps_are_first_and_the_fewest_last:
    # What is kept for several can be listed one by one; `laps: 2` would be the number of each.
    given: {counters: {laps: {B1: 2, B2: 2, B3: 2, Y1: 1, Y2: 3, Y3: 2}}}
    keyframes: [{at_s: 1}]
    lasts_s: 3
    events: [{event: FIRST, payload: {robot_name: Y2}}, {event: LAST, payload: {robot_name: Y1}}]
"""

    def fold(self, numbers: Sequence[Number]) -> Number | None:
        return max(numbers, default=None)
