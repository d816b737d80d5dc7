"""The trigger ``half_ended``."""

from typing import Literal

from rcj_challenges.rules.base import Binder, Phrases, Trigger
from rcj_challenges.rules.triggers.half_started import HalfStarted


class HalfEnded(Trigger):
    """Fires once after the last tick of a half."""

    trigger: Literal["half_ended"]

    IS_TIME = True
    EXAMPLE = HalfStarted.EXAMPLE
    SENTENCE = "a half is over"

    def bind(self, to: Binder) -> None:
        to.clock_events.half_ended.append(to.binding())

    def describe(self, phrases: Phrases) -> str:
        return f"{phrases.period.a} is over"
