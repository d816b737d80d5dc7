"""The value ``timer``."""

from collections.abc import Callable
from math import floor
from typing import Annotated

from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.rules.base import Phrases, Reader, Scope, ValueWord
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.phrasing import quoted, whole_seconds
from rcj_challenges.rules.refs import TIMER, WHOSE


class TimerValue(ValueWord):
    """How long a timer has run, in s with fractions; after it has expired, up to one tick more than its length."""

    timer: Annotated[Name, TIMER] = described(..., "a timer")
    entity: Annotated[Name | None, WHOSE] = described(
        None,
        "for a timer kept per entity: which entity; each: the current member; if omitted and "
        "there is no for_each: the longest",
    )

    KEY = "timer"
    UNIT = "s"
    EXAMPLE = """
timers: {attempt: {lasts_s: 20, starts: true}}
counters: {run_s: {}}
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions:
      # 20 points, less 1 for each whole second; a time to rank by keeps its fraction.
      - {action: score, entrant: yellow, points: [20, {timer: attempt, weight: -1}]}
      - {action: count, counter: run_s, to: {timer: attempt, fraction: true}}
      - {action: emit, event: GOAL, payload: {after_s: {timer: attempt}}}
expect:
  after_five_and_a_half_seconds_it_gives_15_points:
    keyframes: [{at_s: 5.5, place: {ball: [0, 0.8]}}]
    lasts_s: 6
    score: {yellow: 15}
    counters: {run_s: 5.504}
    events: [{event: GOAL, payload: {after_s: 5.504}}]
"""
    SENTENCE = "the time in s that the timer “attempt” has run"

    def now(self, to: Scope) -> Callable[[], float]:
        state, clocks = to.state, to.state.timers[self.timer]
        whose = to.whose(self.entity)
        read = tuple(clocks.values()) if whose is None else (clocks[whose],)
        return lambda: s_from_ticks(max(clock.ticks(state.tick) for clock in read))

    def describe(self, phrases: Phrases) -> str:
        owners = None if self.entity else phrases.owners("timer", self.timer)
        timer = phrases.kept("timer", self.timer, self.entity)
        if owners is not None:
            timer = f"the longest running timer {quoted(self.timer)} of {phrases.all_of(owners).text}"
        return f"the time in {self.UNIT} that {timer} has run"


class NumberTimer(TimerValue):
    """How long a timer has run, in whole seconds, rounded down, or with its fraction."""

    fraction: bool | None = described(
        None, "True: with fractions, to the tick; if omitted: whole seconds, rounded down"
    )

    def number(self, to: Scope) -> Reader:
        read = self.now(to)
        return (lambda _firing: read()) if self.fraction else (lambda _firing: floor(read()))

    def describe_number(self, phrases: Phrases) -> str:
        return whole_seconds(self.describe(phrases), with_fraction=bool(self.fraction))
