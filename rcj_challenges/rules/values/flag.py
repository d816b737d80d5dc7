"""The value ``flag``."""

from collections.abc import Callable
from typing import Annotated

from rcj_challenges.rules.base import Phrases, Reader, Scope, ValueWord
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.phrasing import number
from rcj_challenges.rules.refs import FLAG, WHOSE


class FlagValue(ValueWord):
    """The value of a flag, true or false; as a number 1 or 0."""

    flag: Annotated[Name, FLAG] = described(..., "a flag")
    entity: Annotated[Name | None, WHOSE] = described(
        None,
        "for a flag kept per entity: which entity; each: the current member; if omitted and "
        "there is no for_each: any of them",
    )

    KEY = "flag"
    EXAMPLE = """
flags: {bonus: {initial: true}}
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions:
      # A point, and 5 more if the flag is set.
      - {action: score, entrant: yellow, points: [1, {flag: bonus, weight: 5}]}
      - {action: emit, event: GOAL, payload: {with_bonus: {flag: bonus}}}
      - {action: set_flag, flag: bonus, to: false}
expect:
  the_first_goal_pays_the_bonus:
    keyframes:
      - {at_s: 1, place: {ball: [0, 0.8]}}
      - {at_s: 2, place: {ball: [0, 0]}}
      - {at_s: 3, place: {ball: [0, 0.8]}}
    lasts_s: 4
    score: {yellow: 7}
    events: [{event: GOAL, payload: {with_bonus: true}}, {event: GOAL, payload: {with_bonus: false}}]
"""
    SENTENCE = "whether the flag “bonus” is set"

    def now(self, to: Scope) -> Callable[[], bool]:
        state, name, whose = to.state, self.flag, to.whose(self.entity)
        return lambda: state.flag(name, whose)

    def number(self, to: Scope) -> Reader:
        read = self.now(to)
        return lambda _firing: int(read())

    def describe(self, phrases: Phrases) -> str:
        return f"whether {phrases.kept('flag', self.flag, self.entity)} is set"

    def describe_number(self, phrases: Phrases) -> str:
        return self.describe_times(phrases, 1)

    def describe_times(self, phrases: Phrases, weight: float) -> str:
        return f"{number(weight)} if {phrases.kept('flag', self.flag, self.entity)} is set"
