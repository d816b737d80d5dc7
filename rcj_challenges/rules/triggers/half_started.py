"""The trigger ``half_started``."""

from typing import Literal

from rcj_challenges.rules.base import Binder, Phrases, Trigger
from rcj_challenges.rules.effects import HalfStart


class HalfStarted(Trigger):
    """Fires at tick 0 of every half, after the draws."""

    trigger: Literal["half_started"]

    MOMENT = HalfStart
    EXAMPLE = """
rules:
  begin:
    triggers: [{trigger: half_started}]
    actions: [{action: emit, event: BEGIN}]
  over:
    phases: any
    triggers: [{trigger: half_ended}]
    actions: [{action: emit, event: OVER}]
expect:
  both_are_announced:
    keyframes: [{at_s: 1}]
    lasts_s: 60
    events: [{event: BEGIN, at_s: 0}, {event: OVER, at_s: 60}]
"""

    def bind(self, to: Binder) -> None:
        to.clock_events.half_started.append(to.binding())

    def describe(self, phrases: Phrases) -> str:
        return f"{phrases.period.a} starts"
