"""The trigger ``timer_expired``."""

from dataclasses import replace
from functools import partial
from operator import ne
from typing import Annotated, Literal

from rcj_challenges.core.timing import s_from_ticks
from rcj_challenges.rules.base import Binder, Phrases, Trigger
from rcj_challenges.rules.fields import Name, Names, described
from rcj_challenges.rules.phrasing import quoted
from rcj_challenges.rules.refs import TIMER
from rcj_challenges.tracking.bound_rules import TriggerBinding
from rcj_challenges.tracking.state import Clock, RefereeState
from rcj_challenges.tracking.trackers import NEVER, DueTracker


class TimerExpired(Trigger):
    """Fires when a timer reaches its length."""

    trigger: Literal["timer_expired"]
    timer: Annotated[Name, TIMER] = described(
        ..., "the timer; if it is kept per entity: with for_each, that of the member; otherwise, any of them"
    )

    IS_TIME = True
    MEASURED = "the length in s of the timer"
    EXAMPLE = """
timers:
  patience: {lasts_s: 5}
rules:
  touched:
    triggers: [{trigger: touches, entity: robots, other: ball}]
    actions: [{action: timer, timer: patience, do: restart}]
  no_robot_came:
    triggers: [{trigger: timer_expired, timer: patience}]
    actions: [{action: emit, event: NO_ROBOT_CAME}]
expect:
  it_fires_5_s_after_the_last_touch:
    keyframes:
      - {at_s: 1, touch: [[Y1, ball]]}
      - {at_s: 3, touch: [[Y2, ball]]}
    lasts_s: 10
    events: [{event: NO_ROBOT_CAME, at_s: 8}]
"""

    def bind(self, to: Binder) -> None:
        """Bind a rule to a timer; of one per entity to that of ``each``, else to any of them."""
        clocks = to.state.timers[self.timer]
        each = to.rule.each
        tracker = to.track(TimerTracker, (self.timer,), clocks)
        for member in (each,) if each in clocks else clocks:
            tracker.by_member.setdefault(member, []).append(to.binding(member))

    def describe(self, phrases: Phrases) -> str:
        whose = phrases.one_of_owners("timer", self.timer)
        if whose is None:
            return f"the timer {quoted(self.timer)} runs out"
        return f"{phrases.owned('timer', whose, self.timer)} runs out"

    def about(self, phrases: Phrases) -> Names | None:
        """Return the owners that it can be about; zones and gates are not bound to the rule."""
        return phrases.timer_of(self.timer)

    def limit(self, phrases: Phrases) -> float | None:
        return phrases.timer_length_s(self.timer)

    def measures_its_limit(self) -> bool:
        return True


class TimerTracker(DueTracker):
    """Reports the clocks of a timer that reach their length."""

    def __init__(self, state: RefereeState, clocks: dict[str | None, Clock]) -> None:
        super().__init__(state)
        self.by_member: dict[str | None, list[TriggerBinding]] = {}
        self._clocks = clocks

    @staticmethod
    def _end(clock: Clock) -> int:
        return NEVER if clock.since is None else clock.since + clock.length - clock.elapsed

    def reset(self) -> None:
        """Wait for the clocks that run; what has run out before is past."""
        self.reschedule()

    def reschedule(self) -> None:
        ends = (self._end(clock) for clock in self._clocks.values())
        self.due = min((end for end in ends if end > self._state.tick), default=NEVER)

    def update(self) -> None:
        for member, clock in self._clocks.items():
            if self._end(clock) == self._state.tick:
                ran_s, end = s_from_ticks(clock.length), replace(clock)
                is_past = partial(ne, end, clock)  # an earlier round stopped or restarted it
                self._hits.report(self.by_member.get(member, []), ran_s, clock.length_s, is_past)
        self.reschedule()
