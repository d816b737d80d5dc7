"""The value ``counter``."""

from collections.abc import Callable
from typing import Annotated

from rcj_challenges.rules.base import Number, Phrases, Scope, ValueWord
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.refs import READABLE, WHOSE


class CounterValue(ValueWord):
    """The value of a counter, or an entrant's score."""

    counter: Annotated[Name, READABLE] = described(..., "a counter, or an entrant: its score")
    entity: Annotated[Name | None, WHOSE] = described(
        None,
        "for a counter kept per entity: which entity; each: the current member; if omitted and "
        "there is no for_each: the sum",
    )

    KEY = "counter"
    EXAMPLE = """
counters: {goals: {}}
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions:
      - {action: count, counter: goals}
      # The first goal gives 1 point, the second 2.
      - {action: score, entrant: yellow, points: {counter: goals}}
      - {action: emit, event: GOAL, payload: {goals: {counter: goals}, score: {counter: yellow}}}
expect:
  values_are_read_when_the_action_runs:
    keyframes:
      - {at_s: 1, place: {ball: [0, 0.8]}}
      - {at_s: 2, place: {ball: [0, 0]}}
      - {at_s: 3, place: {ball: [0, 0.8]}}
    lasts_s: 4
    events: [{event: GOAL, payload: {goals: 1, score: 1}}, {event: GOAL, payload: {goals: 2, score: 3}}]
"""
    SENTENCE = "the counter “goals”"

    def now(self, to: Scope) -> Callable[[], Number]:
        state, name, whose = to.state, self.counter, to.whose(self.entity)
        return lambda: state.counter(name, whose)

    def describe(self, phrases: Phrases) -> str:
        return phrases.kept("counter", self.counter, self.entity)
