"""The value ``counter``."""

from typing import Annotated

from rcj_challenges.rules.base import Phrases, Reader, Scope, ValueWord
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.number import amount_words
from rcj_challenges.rules.phrasing import quoted_measure
from rcj_challenges.rules.refs import COUNTER
from rcj_challenges.rules.values.kept import KeptValue


class CounterValue(KeptValue):
    """The value of a counter."""

    counter: Annotated[Name, COUNTER] = described(..., "a counter")

    KEY = "counter"
    EXAMPLE = """
counters: {goals: {}}
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    conditions: [{counter: goals, below: 5}]
    actions:
      - {action: count, counter: goals}
      # The first goal gives 1 point, the second 2.
      - {action: score, entrant: yellow, points: {counter: goals}}
      - {action: emit, event: GOAL, payload: {goals: {counter: goals}, score: {score: yellow}}}
expect:
  values_are_read_when_the_action_runs:
    keyframes:
      - {at_s: 1, place: {ball: [0, 0.8]}}
      - {at_s: 2, place: {ball: [0, 0]}}
      - {at_s: 3, place: {ball: [0, 0.8]}}
    lasts_s: 4
    events: [{event: GOAL, payload: {goals: 1, score: 1}}, {event: GOAL, payload: {goals: 2, score: 3}}]
"""

    def measure(self, to: Scope) -> Reader:
        state, name, whose = to.state, self.counter, self.whose(to)
        return lambda _firing: state.counter(name, whose)

    def describe(self, phrases: Phrases) -> str:
        return self.kept_words(phrases)

    def describe_compared(self, phrases: Phrases, by: Compared) -> str:
        subject = self.several(phrases, by)
        if subject is None:
            return ""
        how = f"equal to {amount_words(phrases, by.equals)}" if isinstance(by.equals, ValueWord) else None
        counter = f"a counter {quoted_measure(self.counter)}"
        return f"{subject.does('has', 'have')} {counter} {how or f'of {by.compared(phrases)}'}"
