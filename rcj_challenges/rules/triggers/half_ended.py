"""The trigger ``half_ended``."""

from typing import Literal

from rcj_challenges.rules.base import Binder, Phrases, Trigger
from rcj_challenges.rules.fields import described
from rcj_challenges.rules.triggers.half_started import HalfStarted


class HalfEnded(Trigger):
    """Fires once after the last tick of a half."""

    trigger: Literal["half_ended"]
    by: Literal["time", "rule"] | None = described(
        None, "by what it was ended: its time is up, or the action `end`; if omitted: either"
    )

    IS_TIME = True
    EXAMPLE = HalfStarted.EXAMPLE

    def bind(self, to: Binder) -> None:
        to.clock_events.half_ended.append((self.by, to.binding()))

    def describe(self, phrases: Phrases) -> str:
        by = {None: "is over", "time": "is over because its time is up", "rule": "is ended by a rule"}[self.by]
        return f"{phrases.period.a} {by}"
