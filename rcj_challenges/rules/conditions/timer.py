"""What is particular to the condition ``timer``."""

from rcj_challenges.rules.base import Binder, Phrases, Test
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.kept import asked, kept
from rcj_challenges.rules.phrasing import quoted
from rcj_challenges.rules.values.number import NumberValue
from rcj_challenges.rules.values.timer import TimerValue


class TimerIs(Compared, TimerValue):
    """How long a timer has run, in s; without a comparison: whether it is running (an expired timer is not)."""

    VALUE = TimerValue
    REQUIRES = ()
    EXAMPLE = """
timers:
  since_touch: {lasts_s: 20}
rules:
  touched:
    triggers: [{trigger: touches, entity: yellow, other: ball}]
    actions: [{action: timer, timer: since_touch, do: restart}]
  quick_goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    # Running, and for at most 2 s; a timer that has never run is at 0.
    conditions: [{timer: since_touch}, {timer: since_touch, at_most: 2}]
    actions: [{action: score, entrant: yellow, points: 2}]
expect:
  a_goal_within_2_s_of_the_touch_gives_two_points:
    keyframes: [{at_s: 1, touch: [[Y1, ball]]}, {at_s: 2.5, place: {ball: [0, 0.8]}}]
    lasts_s: 4
    score: {yellow: 2}
  a_goal_without_a_touch_gives_nothing:
    keyframes: [{at_s: 2.5, place: {ball: [0, 0.8]}}]
    lasts_s: 4
    score: {yellow: 0}
"""
    SENTENCE = "the timer “since touch” has run for at most 2 s"

    def test(self, to: Binder) -> Test:
        if self.limits():
            return super().test(to)
        state, clocks = to.state, to.state.timers[self.timer]

        def is_running(value: NumberValue) -> Test:
            whose = None if not isinstance(value, TimerValue) else value.whose(to)
            read = tuple(clocks.values()) if whose is None else (clocks[whose],)
            return lambda: any(clock.running(state.tick) for clock in read)

        return self.test_of_each(to, is_running)

    def describe(self, phrases: Phrases) -> str:
        if self.value.is_computed():
            return super().describe(phrases)
        subject, run_for = asked(phrases, self, "timer", self.timer), self.compared(phrases, " s")
        timer, no = kept(phrases, self, "timer", self.timer), " not" if self.negate else ""
        if not run_for and subject is None:
            return f"{timer} is{no} running"
        if subject is not None and (self.of is not None or self.entity is not None or not run_for):
            article, state = ("a", f"that has run for {run_for}") if run_for else ("the", "running")
            return f"{subject.does('has', 'have')} {article} timer {quoted(self.timer)} {state}"
        owners = phrases.owners("timer", self.timer)
        if subject is not None and owners is not None:
            timer = f"the longest running timer {quoted(self.timer)} of {phrases.all_of(owners).text}"
        if self.negate and (opposite := self.opposite(phrases, " s")):
            return f"{timer} has run for {opposite}"
        return f"{timer} has{no} run for {run_for}"
