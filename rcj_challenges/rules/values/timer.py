"""The value ``timer``."""

from typing import Annotated

from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.rules.base import Phrases, Reader, Scope, Test
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.phrasing import quoted
from rcj_challenges.rules.refs import TIMER
from rcj_challenges.rules.values.kept import KeptValue
from rcj_challenges.tracking.state import Clock


class TimerValue(KeptValue):
    """How long a timer has run, in s with fractions; after it has expired, up to one tick more than its length."""

    timer: Annotated[Name, TIMER] = described(..., "a timer")

    KEY = "timer"
    UNIT = "s"
    EXAMPLE = """
timers: {attempt: {lasts_s: 20, starts: true}}
counters: {run_s: {}}
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    # Running (one that has expired is not), and for at most 15 s; a timer that has never run is at 0.
    conditions: [{timer: attempt}, {timer: attempt, at_most: 15}]
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
    IS_FACT = True

    def measure(self, to: Scope) -> Reader:
        state, clocks = to.state, self._clocks(to)
        return lambda _firing: s_from_ticks(max(clock.ticks(state.tick) for clock in clocks))

    def fact(self, to: Scope) -> Test:
        state, clocks = to.state, self._clocks(to)
        return lambda: any(clock.running(state.tick) for clock in clocks)

    def _clocks(self, to: Scope) -> tuple[Clock, ...]:
        clocks, whose = to.state.timers[self.timer], self.whose(to)
        return tuple(clocks.values()) if whose is None else (clocks[whose],)

    def describe(self, phrases: Phrases) -> str:
        return f"the time in {self.UNIT} that {self._longest(phrases)} has run"

    def _longest(self, phrases: Phrases) -> str:
        """Return the timer; of those of several the one that has run longest."""
        owners = None if self.entity else phrases.owners("timer", self.timer)
        if owners is None or phrases.one_of_owners("timer", self.timer) == "each":
            return self.kept_words(phrases)
        return f"the longest running timer {quoted(self.timer)} of {phrases.all_of(owners).text}"

    def describe_compared(self, phrases: Phrases, by: Compared) -> str:
        subject, run_for, no = self.several(phrases, by), by.compared(phrases, " s"), " not" * by.negate
        if not run_for and subject is None:
            return f"{self.kept_words(phrases)} is{no} running"
        if subject is not None and (by.of is not None or self.entity is not None or not run_for):
            article, state = ("a", f"that has run for {run_for}") if run_for else ("the", "running")
            return f"{subject.does('has', 'have')} {article} timer {quoted(self.timer)} {state}"
        timer = self.kept_words(phrases) if subject is None else self._longest(phrases)
        if by.compares_with_value():
            return ""
        opposite = by.opposite(phrases, " s") if by.negate else None
        return f"{timer} has run for {opposite}" if opposite else f"{timer} has{no} run for {run_for}"
