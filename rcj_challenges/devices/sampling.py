"""When a sensor takes its next sample, and what all sensors of one kind have in common."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Generic, TypeVar

from rcj_challenges.devices.poses import Poses


class Schedule:
    """Sampling periods of the devices of one family, in ticks.

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


Sensor = TypeVar("Sensor")


class Family(Generic[Sensor]):
    """All sensors of one kind, of all robots; members are numbered in the order in which they were fitted.

    `begin` comes once a tick, then `read` robot by robot: while later robots still look around, the programs of the
    first ones think already.

    Attributes:
        schedule: who samples when.
        due: the members to be sampled at this tick.
        all_due: whether these are all of them, as in most ticks.
        of_robot: by robot, its members and what `read` needs of each.
    """

    def __init__(self, owners: Sequence[int], sensors: Sequence[Sensor]) -> None:
        """Number the members.

        Args:
            owners: the robot of each member.
            sensors: what `read` needs of each member.
        """
        self.schedule = Schedule()
        self.due: Collection[int] = ()
        self.all_due = False
        self.of_robot: dict[int, list[tuple[int, Sensor]]] = {}
        for member, (robot, sensor) in enumerate(zip(owners, sensors, strict=True)):
            self.of_robot.setdefault(robot, []).append((member, sensor))
        self._count = len(sensors)

    def begin(self, tick: int) -> None:
        """Find out who is due at ``tick``, and measure what is measured for all at once."""
        due = self.schedule.due(tick)
        self.all_due = len(due) == self._count
        self.due = due if self.all_due else frozenset(due)

    def read(self, robot: int, tick: int, poses: Poses, own: list[float]) -> None:
        """Write the readings of a robot's members that are due into its numbers."""
        raise NotImplementedError
