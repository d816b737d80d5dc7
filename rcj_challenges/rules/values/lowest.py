"""The limit ``lowest``."""

from collections.abc import Callable
from dataclasses import replace
from typing import Annotated

from rcj_challenges.rules.base import Number, Phrases, Scope, ValueWord
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.phrasing import quoted_measure
from rcj_challenges.rules.refs import COUNTER
from rcj_challenges.rules.values.of_others import of_others


class LowestOfOthers(ValueWord):
    """The lowest value, among all other entities, of a counter kept per entity.

    Entities off the field do not count. If no other one is left, or `each` is off the field, no comparison holds, and
    every negated one does.
    """

    lowest: Annotated[Name, replace(COUNTER, per_entity=True)] = described(
        ...,
        "a counter kept per entity: the lowest value of all members but `each` or, without for_each, of all members",
    )

    KEY = "lowest"
    EXAMPLE = """
counters: {laps: {per: robots}}
rules:
  signal:
    for_each: robots
    triggers: [{trigger: time_reached, at_s: 2}]
    conditions: [{condition: counter, counter: laps, entity: each, at_most: {lowest: laps}}]
    actions: [{action: emit, event: LAST, payload: {robot_name: {word: robot_name}}}]
expect:
  the_robot_with_the_fewest_laps_is_last:
    given: {counters: {laps: {B1: 2, B2: 2, B3: 2, Y1: 2, Y2: 1, Y3: 2}}}
    keyframes: [{at_s: 1}]
    lasts_s: 3
    events: [{event: LAST, payload: {robot_name: Y2}}]
"""
    SENTENCE = "the lowest counter “laps” of all others on the field"

    def now(self, to: Scope) -> Callable[[], Number]:
        """Return a function that reads the lowest value; not a number if there are no others."""
        return of_others(min, self.lowest, to)

    def describe(self, phrases: Phrases) -> str:
        return f"the lowest counter {quoted_measure(self.lowest)} of {phrases.all_but_each(self.lowest)}"
