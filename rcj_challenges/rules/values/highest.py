"""The limit ``highest``."""

from collections.abc import Callable
from dataclasses import replace
from typing import Annotated

from rcj_challenges.rules.base import Number, Phrases, Scope, ValueWord
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.phrasing import quoted_measure
from rcj_challenges.rules.refs import COUNTER
from rcj_challenges.rules.values.of_others import of_others


class HighestOfOthers(ValueWord):
    """The highest value, among all other entities, of a counter kept per entity; see ``lowest``."""

    highest: Annotated[Name, replace(COUNTER, per_entity=True)] = described(
        ...,
        "a counter kept per entity: the highest value of all members but `each` or, without for_each, of all members",
    )

    KEY = "highest"
    EXAMPLE = """
counters: {laps: {per: robots}}
rules:
  signal:
    for_each: robots
    triggers: [{trigger: time_reached, at_s: 2}]
    conditions: [{condition: counter, counter: laps, entity: each, at_least: {highest: laps}}]
    actions: [{action: emit, event: FIRST, payload: {robot_name: {word: robot_name}}}]
expect:
  the_robot_with_the_most_laps_is_first:
    given: {counters: {laps: {B1: 2, B2: 2, B3: 2, Y1: 2, Y2: 3, Y3: 2}}}
    keyframes: [{at_s: 1}]
    lasts_s: 3
    events: [{event: FIRST, payload: {robot_name: Y2}}]
"""
    SENTENCE = "the highest counter “laps” of all others on the field"

    def now(self, to: Scope) -> Callable[[], Number]:
        """Return a function that reads the highest value; not a number if there are no others."""
        return of_others(max, self.highest, to)

    def describe(self, phrases: Phrases) -> str:
        return f"the highest counter {quoted_measure(self.highest)} of {phrases.all_but_each(self.highest)}"
