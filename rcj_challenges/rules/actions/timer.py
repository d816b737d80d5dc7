"""The action ``timer``."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import Act, Action, Binder, Firing, Phrases
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.refs import WHOSE, WRITTEN_TIMER
from rcj_challenges.tracking.state import Clock


class TimerAction(Action):
    """Start, stop or reset a timer."""

    action: Literal["timer"]
    timer: Annotated[Name, WRITTEN_TIMER] = described(..., "the timer")
    entity: Annotated[Name | None, WHOSE] = described(
        None, "for a timer kept per entity: which entity, or each; if omitted: all of them"
    )
    do: Literal["restart", "start", "stop", "reset"] = described(
        "restart", "restart: start from 0; start: continue; stop: pause; reset: stop and return to 0"
    )

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
    SENTENCE = "the timer “stopwatch” is stopped"

    def compile(self, to: Binder) -> Act:
        state, do, timer = to.state, self.do, self.timer
        clocks, whose = state.timers[timer], to.whose(self.entity)
        chosen = tuple(clocks.items()) if whose is None else ((whose, clocks[whose]),)

        def change(owner: str | None, clock: Clock) -> None:
            elapsed = clock.ticks(state.tick)
            if do == "restart" or (do == "start" and clock.since is None and elapsed == 0):
                to.set_length(timer, owner)
                clock.elapsed, clock.since = 0, state.tick
            elif do == "reset":
                clock.elapsed, clock.since = 0, None
            elif do == "stop":
                clock.elapsed, clock.since = elapsed, None
            elif clock.since is None and elapsed < clock.length:
                clock.since = state.tick

        def act(_firing: Firing) -> None:
            for owner, clock in chosen:
                change(owner, clock)
            to.timers_changed()

        return act

    def describe(self, phrases: Phrases) -> str:
        done = {
            "restart": "starts again from 0",
            "start": "starts or goes on, unless it has run out",
            "stop": "is stopped",
            "reset": "is stopped and set to 0",
        }[self.do]
        return f"{phrases.every_kept('timer', self.timer, self.entity)} {done}"
