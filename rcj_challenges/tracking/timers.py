"""Timers that run while something holds."""

from __future__ import annotations

from collections.abc import Callable

from rcj_challenges.tracking.bound_rules import HitBuffer, Test
from rcj_challenges.tracking.state import Clock, RefereeState
from rcj_challenges.tracking.trackers import TickTracker


class RunsWhile(TickTracker):
    """Lets a clock run from a tick in which a test holds to the next one in which it does not."""

    def __init__(
        self, state: RefereeState, hits: HitBuffer, clock: Clock, test: Test, reschedule: Callable[[], None]
    ) -> None:
        super().__init__(state, hits)
        self._clock = clock
        self._test = test
        self._reschedule = reschedule

    def reset(self) -> None:
        """Look again: what the test says may have changed."""
        self.update()

    def update(self) -> None:
        """Start or stop the clock, as the test says."""
        clock, tick = self._clock, self._state.tick
        holds = bool(self._test())
        if holds == (clock.since is not None):
            return
        clock.elapsed = clock.ticks(tick)
        clock.since = tick if holds else None
        self._reschedule()
