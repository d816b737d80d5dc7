"""The action ``timer``."""

from typing import Annotated, Literal

from rcj_challenges.core.timing import ticks_from_s
from rcj_challenges.rules.base import Act, Action, Binder, Firing, Phrases
from rcj_challenges.rules.fields import Name, Names, described
from rcj_challenges.rules.refs import WHOSE_OF, WRITTEN_TIMER
from rcj_challenges.rules.values import Amount, compile_duration, duration_words
from rcj_challenges.tracking.state import Clock


class TimerAction(Action):
    """Start, stop, reset or lengthen a timer."""

    action: Literal["timer"]
    timer: Annotated[Name, WRITTEN_TIMER] = described(..., "the timer")
    entity: Annotated[Names | None, WHOSE_OF] = described(
        None, "if it is kept per entity: whose; if omitted: that of each in a rule for_each of its owners, else all"
    )
    do: Literal["restart", "start", "stop", "reset", "add"] = described(
        "restart",
        "restart: start from 0; start: continue; stop: pause; reset: stop and return to 0; add: `s` more to run",
    )
    s: Amount | None = described(
        None, "with add: how many s longer it lasts until it starts from 0 again; 0 or less, or no such number: none"
    )

    TOGETHER = (("s", "do", "add"),)
    EXAMPLE = """
timers: {stopwatch: {lasts_s: 10, starts: true}}
rules:
  hold:
    triggers: [{trigger: time_reached, at_s: 1}]
    actions: [{action: timer, timer: stopwatch, do: stop}]
  go_on:
    triggers: [{trigger: time_reached, at_s: 5}]
    actions: [{action: timer, timer: stopwatch, do: start}]
  over:
    triggers: [{trigger: timer_expired, timer: stopwatch}]
    actions: [{action: emit, event: OVER}]
expect:
  four_seconds_do_not_count:
    keyframes: [{at_s: 1}]
    lasts_s: 16
    events: [{event: OVER, at_s: 14, tolerance_s: 0.1}]
"""

    def compile(self, to: Binder) -> Act:
        state, do, timer = to.state, self.do, self.timer
        clocks, whose = state.timers[timer], to.owners("timers", timer, self.entity)
        longer_s = None if self.s is None else compile_duration(self.s, to)
        chosen = tuple((one, clocks[one]) for one in (clocks if whose is None else whose))

        def change(owner: str | None, clock: Clock, more_s: float) -> None:
            elapsed = clock.ticks(state.tick)
            if do == "add":
                # What has run out stands at its end, and goes on from there.
                clock.elapsed, clock.since = elapsed, None if clock.since is None else state.tick
                clock.length_s += more_s
                clock.length += ticks_from_s(more_s)
            elif do == "restart" or (do == "start" and clock.since is None and elapsed == 0):
                to.set_length(timer, owner)
                clock.elapsed, clock.since = 0, state.tick
            elif do == "reset":
                clock.elapsed, clock.since = 0, None
            elif do == "stop":
                clock.elapsed, clock.since = elapsed, None
            elif clock.since is None and elapsed < clock.length:
                clock.since = state.tick

        def act(firing: Firing) -> None:
            more_s = 0.0 if longer_s is None else longer_s(firing) or 0.0
            for owner, clock in chosen:
                change(owner, clock, more_s)
            to.trackers.reschedule()

        return act

    def describe(self, phrases: Phrases) -> str:
        done = {
            "restart": "starts again from 0",
            "start": "starts or goes on, unless it has run out",
            "stop": "is stopped",
            "reset": "is stopped and set to 0",
            "add": f"lasts {'' if self.s is None else duration_words(phrases, self.s)} longer",
        }[self.do]
        return f"{phrases.every_kept('timer', self.timer, self.entity)} {done}"
