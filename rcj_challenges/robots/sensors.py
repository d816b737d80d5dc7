"""All that one robot senses, apart from radio: which of its sensors are due, and their numbers."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence

from rcj_challenges.core.grouping import grouped
from rcj_challenges.devices.base import Reader, Sensor
from rcj_challenges.devices.poses import RobotPose


class Schedule:
    """Sampling periods of the sensors of one robot, in ticks.

    A device enabled at tick k with period n is sampled at k + n, k + 2 n, …; enabling it again with the period it
    already has changes nothing (programs that call ``enable`` in their loop would otherwise never get a sample).

    Attributes:
        every_tick, seldom: the members that are due at every tick, and those that are not, in order.
    """

    def __init__(self) -> None:
        self._period: dict[int, int] = {}
        self._next: dict[int, int] = {}
        self.every_tick: list[int] = []
        self.seldom: list[int] = []

    def set(self, member: int, period_ticks: int, now: int) -> None:
        """Set the period of a member; 0 disables it."""
        if self._period.get(member, 0) == period_ticks:
            return
        self._period[member] = period_ticks
        self._next[member] = now + period_ticks
        self.every_tick = sorted(m for m, period in self._period.items() if period == 1)
        self.seldom = sorted(m for m, period in self._period.items() if period > 1)

    def enabled(self) -> Sequence[int]:
        """Return the members with a period, in order."""
        return self.every_tick if not self.seldom else sorted(self.every_tick + self.seldom)

    def due(self, tick: int) -> Sequence[int]:
        """Return the members to be sampled at ``tick``, in order. To be asked once per tick."""
        if not self.seldom:
            return self.every_tick
        ready = []
        for member in self.seldom:
            if tick >= self._next[member]:
                self._next[member] = tick + self._period[member]
                ready.append(member)
        return sorted(self.every_tick + ready) if ready else self.every_tick


class RobotSensors:
    """The sensors of one robot; ``values`` are the numbers of all its devices, by slot.

    Its program is started on its next step as soon as they are read, so this is where a match waits. Those that are
    due are read class by class (ADR 10).
    """

    def __init__(self, sensors: Mapping[int, Sensor], values: int, pose: RobotPose) -> None:
        """Build them from the sensors by index of the device; the devices have so many ``values``."""
        self.values = [math.nan] * values
        self._sensors = sensors
        self._pose = pose
        self._schedule = Schedule()
        self._known: dict[tuple[int, ...], list[Reader]] = {}
        for sensor in sensors.values():
            sensor.clear(self.values)
        self._choose(())

    def set_period(self, device: int, period_ticks: int, now: int) -> None:
        """Let a sensor take samples every so many ticks; 0 disables it, and its numbers are gone."""
        if device not in self._sensors:
            return
        self._schedule.set(device, period_ticks, now)
        if not period_ticks:
            self._sensors[device].clear(self.values)
        self._choose(self._schedule.every_tick)

    def set_frequency(self, device: int, frequency_hz: float) -> None:
        """Set the frequency of a sensor that turns."""
        if device in self._sensors:
            self._sensors[device].set_frequency(frequency_hz)

    def close(self, now: int) -> None:
        """Take no more samples; the numbers stay."""
        for device in tuple(self._schedule.enabled()):
            self._schedule.set(device, 0, now)
        self._choose(())

    def _choose(self, due: Sequence[int]) -> None:
        """Look up the functions that read the sensors that are due, and the sensors that move on."""
        key = tuple(due)
        readers = self._known.get(key)
        if readers is None:
            by_class = grouped((type(self._sensors[device]), self._sensors[device]) for device in due)
            readers = self._known[key] = [kind.reader(some) for kind, some in by_class.items()]
        self._due = readers
        enabled = (self._sensors[device] for device in self._schedule.enabled())
        self._advancing = [sensor for sensor in enabled if sensor.advances]

    def read(self, tick: int) -> None:
        """Take the samples that are due. To be called once per tick."""
        if self._schedule.seldom:
            self._choose(self._schedule.due(tick))
        pose, values = self._pose, self.values
        for sensor in self._advancing:
            sensor.advance(tick, pose)
        for read in self._due:
            read(tick, pose, values)
