"""The value ``timer``."""

from collections.abc import Callable
from typing import Annotated

from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.rules.base import Phrases, Scope
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.phrasing import quoted
from rcj_challenges.rules.refs import TIMER
from rcj_challenges.rules.values.kept import KeptValue


class TimerValue(KeptValue):
    """How long a timer has run, in s with fractions; after it has expired, up to one tick more than its length."""

    timer: Annotated[Name, TIMER] = described(..., "a timer")

    KEY = "timer"
    IN = "timers"
    UNIT = "s"
    EXAMPLE = """
timers: {attempt: {lasts_s: 20, starts: true}}
counters: {run_s: {}}
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions:
      # 20 points, less 1 for each whole second.
      - {action: score, entrant: yellow, points: {timer: attempt, times: -1, plus: 20, round: up}}
      - {action: count, counter: run_s, to: {timer: attempt}}
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
        whose = self.whose(to)
        read = tuple(clocks.values()) if whose is None else (clocks[whose],)
        return lambda: s_from_ticks(max(clock.ticks(state.tick) for clock in read))

    def describe(self, phrases: Phrases) -> str:
        owners = None if self.entity else phrases.owners("timer", self.timer)
        timer = self.kept_words(phrases)
        if owners is not None:
            timer = f"the longest running timer {quoted(self.timer)} of {phrases.all_of(owners).text}"
        return f"the time in {self.UNIT} that {timer} has run"
