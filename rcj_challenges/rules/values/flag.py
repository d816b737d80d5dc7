"""The value ``flag``."""

from typing import Annotated

from rcj_challenges.rules.base import Phrases, Reader, Scope, Test
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.phrasing import number, quoted
from rcj_challenges.rules.refs import FLAG
from rcj_challenges.rules.values.kept import KeptValue


class FlagValue(KeptValue):
    """The value of a flag, true or false; as a number 1 or 0."""

    flag: Annotated[Name, FLAG] = described(..., "a flag")

    KEY = "flag"
    EXAMPLE = """
flags: {bonus: {initial: true}}
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions:
      # A point, and 5 more if the flag is set.
      - {action: score, entrant: yellow, points: {flag: bonus, times: 5, plus: 1}}
      - {action: emit, event: GOAL, payload: {with_bonus: {flag: bonus}}}
      - {action: set_flag, flag: bonus, to: false}
  last:
    triggers: [{trigger: time_reached, at_s: 10}]
    conditions: [{flag: bonus}]
    actions: [{action: emit, event: STILL_OPEN}]
expect:
  the_first_goal_pays_the_bonus:
    keyframes:
      - {at_s: 1, place: {ball: [0, 0.8]}}
      - {at_s: 2, place: {ball: [0, 0]}}
      - {at_s: 3, place: {ball: [0, 0.8]}}
    lasts_s: 11
    score: {yellow: 7}
    events: [{event: GOAL, payload: {with_bonus: true}}, {event: GOAL, payload: {with_bonus: false}}]
"""
    IS_FACT = True

    def measure(self, to: Scope) -> Reader:
        is_set = self.fact(to)
        return lambda _firing: is_set()

    def fact(self, to: Scope) -> Test:
        state, name, whose = to.state, self.flag, self.whose(to)
        return lambda: state.flag(name, whose)

    def describe(self, phrases: Phrases) -> str:
        return f"whether {self.kept_words(phrases)} is set"

    def describe_number(self, phrases: Phrases) -> str:
        return self.describe_times(phrases, 1)

    def describe_times(self, phrases: Phrases, factor: float) -> str:
        return f"{number(factor)} if {self.kept_words(phrases)} is set"

    def describe_compared(self, phrases: Phrases, by: Compared) -> str:
        if by.limits():
            return ""
        subject = self.several(phrases, by)
        if subject is not None:
            return f"{subject.does('has', 'have')} the flag {quoted(self.flag)} set"
        return f"{self.kept_words(phrases)} is {'not ' if by.negate else ''}set"
