"""When a sensor takes its next sample."""

from __future__ import annotations

from collections.abc import Sequence


class Schedule:
    """Sampling periods of the sensors of one robot, in ticks.

    A device enabled at tick k with period n is sampled at k + n, k + 2 n, …; enabling it again with the period it
    already has changes nothing (programs that call ``enable`` in their loop would otherwise never get a sample).
    """

    def __init__(self) -> None:
        self._period: dict[int, int] = {}
        self._next: dict[int, int] = {}
        self._every_tick: list[int] = []
        self._seldom: list[int] = []

    def set(self, member: int, period_ticks: int, now: int) -> None:
        """Set the period of a member; 0 disables it."""
        if self._period.get(member, 0) == period_ticks:
            return
        self._period[member] = period_ticks
        self._next[member] = now + period_ticks
        self._every_tick = sorted(m for m, period in self._period.items() if period == 1)
        self._seldom = sorted(m for m, period in self._period.items() if period > 1)

    @property
    def even(self) -> bool:
        """Whether the same members are due at every tick."""
        return not self._seldom

    def enabled(self) -> Sequence[int]:
        """Return the members with a period, in order."""
        return self._every_tick if not self._seldom else sorted(self._every_tick + self._seldom)

    def due(self, tick: int) -> Sequence[int]:
        """Return the members to be sampled at ``tick``, in order. To be asked once per tick."""
        if not self._seldom:
            return self._every_tick
        ready = []
        for member in self._seldom:
            if tick >= self._next[member]:
                self._next[member] = tick + self._period[member]
                ready.append(member)
        return sorted(self._every_tick + ready) if ready else self._every_tick
