"""Whether the next tick follows so soon that a program had better wait for it awake, and who may be where meanwhile.

While the match simulates a tick nobody else has anything to do, and the processor on which the programs were falls
asleep. To wake it up takes as long as two programs think, and in a virtual machine a good part of that from the match
itself. And where no processor is asleep Linux wakes programs on the one on which the match is (ADR 10).

Where all processors are busy, with other matches perhaps, nobody stays awake. Then programs are best off where the
match is, which wakes them: what they and it need again and again stays in the caches of one processor, and they take
turns with the match instead of waiting for somebody else to make room.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Mapping

from rcj_challenges.controllers import scheduling, tasks
from rcj_challenges.controllers.scheduling import AS_EVERYBODY, Manners
from rcj_challenges.facts.timing import TICK_S

SOON_S = 0.001
"""Ticks that take longer, because somebody computes or waits for the clock on the wall, are slept through."""

LITTLE = 0.4
"""Programs that keep less than this of one processor busy leave the match its own: there they would be done no sooner.
(ADR 10 has what was measured; those that compute for longer are better off on all.)"""

UNHURRIED_S = TICK_S / 2
"""Where ticks take longer, because the match is watched or somebody computes, it does not matter who is where."""

_LOOKED_EVERY_TICKS = 64


class Haste:
    """Tells that of each tick. It only makes a match faster: the programs' results and limits do not depend on it.

    One stays awake only where a processor has nothing else to do: beside other matches it would hold everybody up.

    Attributes:
        manners: of the programs from now on; another object only if they change.
    """

    def __init__(self, computed_s: Callable[[], Mapping[int, float]]) -> None:
        """Begin.

        Args:
            computed_s: tells for how long each program that plays has computed until now, by robot.
        """
        self._processors, self._of_computer = tasks.processors(), tasks.all_processors()
        self._was_full = False
        self._began_s = -math.inf
        self._ticks = 0
        self._computed_s_until_now = computed_s
        self._looked_s, self._ours_s = math.nan, 0.0
        self._computed_s: Mapping[int, float] = {}
        self._awake: set[int] = set()
        self.manners = AS_EVERYBODY

    def next_is_soon(self, robot: int) -> bool:
        """Return whether the next tick is expected so soon. To be called once a tick, before programs are released.

        Args:
            robot: whose program is going to wait for it awake.
        """
        now_s = time.perf_counter()
        was_soon, self._began_s = now_s - self._began_s < SOON_S, now_s
        self._ticks += 1
        phase = self._ticks % _LOOKED_EVERY_TICKS
        if phase == 0:
            self._look(now_s)
        # Before that is looked at, the one who was awake has to sleep: it would be counted.
        soon = was_soon and self.manners.gives_way and phase != _LOOKED_EVERY_TICKS - 1
        if soon:
            self._awake.add(robot)
        return soon

    def somebody_computes(self) -> None:
        """Let all be on all processors until it is looked at again: the match waits for a program, and needs none."""
        if self.manners.leaves is not None or self.manners.keeps_to is not None:
            self.manners = Manners(self.manners.gives_way)

    def _look(self, now_s: float) -> None:
        """Find out whether there is room, and whether one processor is enough for the programs."""
        running, was_full = tasks.running(), self._was_full
        busy, ours, tick_s = self._measured(now_s)
        # All of them, not those that we are granted: others may be busy elsewhere on a large computer.
        self._was_full = running >= self._of_computer > 0
        manners = AS_EVERYBODY
        if 0 < running < self._processors:
            few = tick_s < SOON_S and busy < LITTLE
            manners = Manners(gives_way=True, leaves=scheduling.processor_here() if few else None)
        elif self._was_full and was_full and tick_s < UNHURRIED_S and busy < ours:
            # Of programs that compute for less than the match nobody would gain by a share of other processors.
            manners = Manners(gives_way=False, keeps_to=scheduling.processor_here())
        if manners != self.manners:
            self.manners = manners

    def _measured(self, now_s: float) -> tuple[float, float, float]:
        """Return of the time since this was last asked: how busy programs have kept a processor, and the match; a tick.

        The first two are shares of one processor, the third is in s.
        """
        before_s, self._computed_s = self._computed_s, self._computed_s_until_now()
        ours_s, self._ours_s = self._ours_s, time.thread_time()
        lasted_s, self._looked_s = now_s - self._looked_s, now_s
        # Those that were awake did nothing but wait, and of one that has ended meanwhile nobody knows.
        counted = [robot for robot in self._computed_s if robot in before_s and robot not in self._awake]
        computed_s = sum(max(0.0, self._computed_s[robot] - before_s[robot]) for robot in counted)
        self._awake.clear()
        return computed_s / lasted_s, (self._ours_s - ours_s) / lasted_s, lasted_s / _LOOKED_EVERY_TICKS
