"""What a robot knows of itself: wheel angles, position, heading.

Those without noise and in today's frame are so many, and so simple, that `senses.Senses` reads them itself.
"""

from __future__ import annotations

import math
from typing import cast

from rcj_challenges.devices.fitting import Fitted
from rcj_challenges.devices.ground import Ground
from rcj_challenges.devices.noise import Noise
from rcj_challenges.devices.poses import RobotPose, Vector
from rcj_challenges.facts.play import HalfInfo
from rcj_challenges.scenario.models.robots import CompassDevice, GpsDevice, WheelSensorDevice

WheelSensor = tuple[int, int, int]
"""A wheel's turning angle since the start of the half, in rad: slot, place in `qpos`, and which way it counts.

A plain tuple: Python takes twice as long to unpack a named one, and does so for all wheels at every tick.
"""


def wheel_sensor(one: Fitted, ground: Ground) -> WheelSensor:
    """Return the sensor of a wheel."""
    device = cast("WheelSensorDevice", one.device)
    at = int(ground.model.joint(f"{one.robot_name}/{device.wheel}_wheel").qposadr[0])
    return one.spec.slot, at, device.direction


class _BodySensor:
    """Three numbers of a robot's body, in today's frame or the legacy one, with noise or without."""

    def __init__(self, one: Fitted, half: HalfInfo, sigma: float, draws: int) -> None:
        """Open the stream of noise, if it has any.

        Args:
            one: the device on its robot.
            half: for the noise.
            sigma: standard deviation of its noise.
            draws: how many errors it has in a tick.
        """
        device = cast("GpsDevice | CompassDevice", one.device)
        self.slot = one.spec.slot
        self._legacy = device.frame == "legacy"
        self._sigma = sigma
        self._noise = Noise(half, [(one.robot_name, one.spec.name)], draws) if sigma else None

    @property
    def plain(self) -> bool:
        """Whether it shows things as they are."""
        return self._noise is None and not self._legacy


class Gps(_BodySensor):
    """The cube's centre in m: [x, y, z], or [y, z, x] in the legacy frame."""

    def __init__(self, one: Fitted, half: HalfInfo) -> None:
        """See `_BodySensor`."""
        super().__init__(one, half, cast("GpsDevice", one.device).noise_m, draws=3)

    def read(self, tick: int, pose: RobotPose, values: list[float]) -> None:
        """Write the reading of a tick into the robot's numbers."""
        x, y, z = pose.x, pose.y, pose.z
        if self._noise is not None:
            error_x, error_y, error_z = self._noise.numbers(tick)
            x, y, z = x + self._sigma * error_x, y + self._sigma * error_y, z + self._sigma * error_z
        values[self.slot : self.slot + 3] = (y, z, x) if self._legacy else (x, y, z)


class Compass(_BodySensor):
    """The world's +y in the robot's frame: [sin ψ, cos ψ, 0] when level, or [cos θ, 0, sin θ] in the legacy frame."""

    def __init__(self, one: Fitted, half: HalfInfo) -> None:
        """See `_BodySensor`."""
        super().__init__(one, half, cast("CompassDevice", one.device).noise_rad, draws=1)

    def read(self, tick: int, pose: RobotPose, values: list[float]) -> None:
        """Write the reading of a tick into the robot's numbers."""
        forward, left, up = pose.north()
        if self._noise is not None:
            forward, left = _turned(forward, left, self._sigma * self._noise.numbers(tick)[0])
        shown: Vector = (left, up, forward) if self._legacy else (forward, left, up)
        values[self.slot : self.slot + 3] = shown


def _turned(forward: float, left: float, by_rad: float) -> tuple[float, float]:
    cos, sin = math.cos(by_rad), math.sin(by_rad)
    return forward * cos + left * sin, left * cos - forward * sin
