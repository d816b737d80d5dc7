"""All that one robot senses, but for radio: which of its sensors are due, and their numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Protocol

from rcj_challenges.devices.body_sensors import Compass, Gps, WheelSensor, wheel_sensor
from rcj_challenges.devices.fitting import Fitted
from rcj_challenges.devices.ground import Ground
from rcj_challenges.devices.lidar import NOT_YET_SWEPT, Lidar
from rcj_challenges.devices.poses import Poses, RobotPose
from rcj_challenges.devices.sampling import Schedule
from rcj_challenges.devices.sonar import Echoes, Sonar
from rcj_challenges.facts.play import HalfInfo
from rcj_challenges.scenario.models.scenario import Scenario


class _Sensor(Protocol):
    """A sensor that reads itself."""

    def read(self, tick: int, pose: RobotPose, values: list[float]) -> None:
        """Write the reading of a tick into the robot's numbers."""
        ...


class Senses:
    """The sensors of one robot.

    Its program is started on its next step as soon as they are read, so this is where a match waits. Sensors of a kind
    stand in a list of those that are due, and the commonest kinds are read in one function (ADR 10).

    Attributes:
        values: the numbers of all its devices, by slot.
        sonars: those that are due.
    """

    def __init__(
        self, robot: int, fitted: Sequence[Fitted], scenario: Scenario, ground: Ground, half: HalfInfo, poses: Poses,
        echoes: Echoes | None,
    ) -> None:  # fmt: skip
        """Fit the sensors of a robot.

        Args:
            robot: its index.
            fitted: all devices of all robots.
            scenario: for the shape of robots and balls.
            ground: the world.
            half: for the noise.
            poses: refreshed every tick.
            echoes: of the sonars of all robots; None if there are none.
        """
        self._fitted = {one.spec.index: one for one in fitted if one.robot == robot and one.spec.width}
        self.values = [math.nan] * sum(one.spec.width for one in self._fitted.values())
        self._poses, self._pose, self._echoes = poses, poses.robots[robot], echoes
        self._schedule = Schedule()
        self._all_wheels: dict[int, WheelSensor] = {}
        self._all_places: dict[int, int] = {}
        self._all_norths: dict[int, int] = {}
        self._all_sonars: dict[int, Sonar] = {}
        self._all_lidars: dict[int, Lidar] = {}
        self._all_others: dict[int, _Sensor] = {}
        for index, one in self._fitted.items():
            self._add(index, one, scenario, ground, half)
            self._blank(one)
        self._choose(())

    def _add(self, index: int, one: Fitted, scenario: Scenario, ground: Ground, half: HalfInfo) -> None:
        match one.spec.kind:
            case "position_sensor":
                self._all_wheels[index] = wheel_sensor(one, ground)
            case "gps":
                self._add_body_sensor(index, Gps(one, half), self._all_places)
            case "compass":
                self._add_body_sensor(index, Compass(one, half), self._all_norths)
            case "distance_sensor" if self._echoes is not None:
                self._all_sonars[index] = self._echoes.sonars[one.robot, index]
            case "lidar":
                self._all_lidars[index] = Lidar(one, scenario, ground, half)

    def _add_body_sensor(self, index: int, sensor: Gps | Compass, plain: dict[int, int]) -> None:
        if sensor.plain:
            plain[index] = sensor.slot
        else:
            self._all_others[index] = sensor

    @property
    def even(self) -> bool:
        """Whether the same sensors are due at every tick; if not, `choose` is to be called at each."""
        return self._schedule.even

    def enabled(self) -> Sequence[int]:
        """Return the devices that take samples, by index."""
        return self._schedule.enabled()

    def set_period(self, device: int, period_ticks: int, now: int) -> None:
        """Let a sensor take samples every so many ticks; 0 disables it, and its numbers are gone."""
        if device not in self._fitted:
            return
        self._schedule.set(device, period_ticks, now)
        if not period_ticks:
            self._blank(self._fitted[device])
            if device in self._all_lidars:
                self._all_lidars[device].clear()
        if self.even:
            self.choose(now)

    def set_frequency(self, device: int, frequency_hz: float) -> None:
        """Set how fast the head of a lidar turns."""
        if device in self._all_lidars:
            self._all_lidars[device].set_frequency(frequency_hz)

    def close(self, now: int) -> None:
        """Take no more samples; the numbers stay."""
        for device in tuple(self.enabled()):
            self._schedule.set(device, 0, now)
        self.choose(now)

    def choose(self, tick: int) -> None:
        """Find out which sensors are due at ``tick``. To be called once per tick at most."""
        self._choose(self._schedule.due(tick))

    def _choose(self, due: Sequence[int]) -> None:
        self._wheels = [self._all_wheels[device] for device in due if device in self._all_wheels]
        self._places = [self._all_places[device] for device in due if device in self._all_places]
        self._norths = [self._all_norths[device] for device in due if device in self._all_norths]
        self.sonars = [self._all_sonars[device] for device in due if device in self._all_sonars]
        others: list[_Sensor] = [self._all_others[device] for device in due if device in self._all_others]
        self._others = others + [self._all_lidars[device] for device in due if device in self._all_lidars]
        # The heads turn between samples too.
        self._turning = [
            lidar
            for device, lidar in self._all_lidars.items()
            if lidar.device.rotating and device in self._schedule.enabled()
        ]

    def read(self, tick: int) -> None:
        """Take the samples that are due. The sonars' echoes have been measured."""
        values, pose, state = self.values, self._pose, self._poses.state
        for slot, at, direction in self._wheels:
            values[slot] = direction * state[at]
        for slot in self._places:
            values[slot], values[slot + 1], values[slot + 2] = pose.x, pose.y, pose.z
        for slot in self._norths:
            values[slot], values[slot + 1], values[slot + 2] = pose.north()
        if self.sonars and self._echoes is not None:
            self._echoes.read(self.sonars, values)
        for lidar in self._turning:
            lidar.turn(tick, pose)
        for sensor in self._others:
            sensor.read(tick, pose, values)

    def _blank(self, one: Fitted) -> None:
        """Make a device's numbers those of one that has not been sampled."""
        blank = NOT_YET_SWEPT if one.spec.kind == "lidar" else math.nan
        slot, width = one.spec.slot, one.spec.width
        self.values[slot : slot + width] = [blank] * width
