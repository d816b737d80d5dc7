"""The trigger ``time_reached``."""

from typing import Literal

from rcj_challenges.core.timing import TICK_S
from rcj_challenges.rules.base import Binder, Phrases, Trigger
from rcj_challenges.rules.effects import AtTime
from rcj_challenges.rules.fields import described
from rcj_challenges.rules.values import Lasts, compile_limit, duration_words, every_words
from rcj_challenges.tracking.clock_events import Alarm


class TimeReached(Trigger):
    """Fires when the clock of the half reaches a given time and, with ``every_s``, again at intervals."""

    trigger: Literal["time_reached"]
    at_s: Lasts = described(..., "time since the start of the half in s; a value is read as the half starts")
    every_s: Lasts | None = described(
        None, "interval in s at which it fires again, counted from at_s, until the half ends; if omitted: it fires once"
    )

    IS_TIME = True
    MEASURED = "the time in s"
    LIMIT = "at_s"
    MOMENT = AtTime
    EXAMPLE = """
rules:
  half_way:
    triggers: [{trigger: time_reached, at_s: 30}]
    actions: [{action: emit, event: HALF_WAY}]
  every_5_s:
    triggers: [{trigger: time_reached, at_s: 5, every_s: 5}]
    actions: [{action: count, counter: rounds}]
counters: {rounds: {}}
expect:
  it_fires_after_30_s:
    keyframes: [{at_s: 1}]
    lasts_s: 40
    events: [{event: HALF_WAY, at_s: 30}]
    counters: {rounds: 8}
"""

    def bind(self, to: Binder) -> None:
        binding, at_s = to.binding(), compile_limit(self.at_s, to, TICK_S)
        every_s = None if self.every_s is None else compile_limit(self.every_s, to, TICK_S)
        to.clock_events.alarms.append(lambda: Alarm(binding, at_s(), None if every_s is None else every_s()))

    def describe(self, phrases: Phrases) -> str:
        again = f", and again {every_words(phrases, self.every_s)} until it ends" if self.every_s else ""
        # Where a phase stops the clock, the half lasts longer than that shows.
        half = phrases.period
        lasted = f"clock of the {half} has reached" if phrases.clock_may_stop() else f"{half} has lasted"
        return f"the {lasted} {duration_words(phrases, self.at_s)}{again}"

    def measures_its_limit(self) -> bool:
        return not self.every_s
