"""Whether the next tick follows so soon that a program had better wait for it awake.

While the match simulates a tick nobody else has anything to do, and the processor on which the programs were falls
asleep. To wake it up takes as long as two programs think, and in a virtual machine a good part of that from the match
itself (ADR 10).
"""

from __future__ import annotations

import math
import time

from rcj_challenges.controllers import tasks

SOON_S = 0.001
"""Ticks that take longer, because somebody computes or waits for the clock on the wall, are slept through."""

_LOOKED_EVERY_TICKS = 16


class Haste:
    """Tells that of each tick. It only makes a match faster: no program can see it.

    Only where a processor has nothing else to do: beside other matches, those that stay awake would hold everybody up.

    Attributes:
        is_room: whether there was one when that was last looked at.
    """

    def __init__(self) -> None:
        self._processors = tasks.processors()
        self._began_s = -math.inf
        self._ticks = 0
        self.is_room = False

    def next_is_soon(self) -> bool:
        """Return whether the next tick is expected so soon. To be called once a tick, before programs are released."""
        now_s = time.perf_counter()
        was_soon, self._began_s = now_s - self._began_s < SOON_S, now_s
        self._ticks += 1
        phase = self._ticks % _LOOKED_EVERY_TICKS
        if phase == 0:
            self.is_room = 0 < tasks.running() < self._processors
        # Before that is looked at, the one who was awake has to sleep: it would be counted.
        return was_soon and self.is_room and phase != _LOOKED_EVERY_TICKS - 1
