"""The device ``touch_sensor``: a bumper."""

import math
from typing import Literal

from rcj_challenges.devices.base import Device, Fitted, Sensor, SensorContext
from rcj_challenges.devices.poses import RobotPose
from rcj_challenges.rules.fields import Positive, described
from rcj_challenges.rules.phrasing import degrees


class TouchSensorDevice(Device):
    """Whether the robot touched a wall, an obstacle or a robot in the last tick; balls are too light for it."""

    device: Literal["touch_sensor"]
    bearing_rad: float = described(
        0.0, "direction of its middle in the robot's frame in rad; 0 front, 1.5708 left (+y)"
    )
    angle_rad: Positive = described(6.2832, "angle that it covers in rad; left out: all around", le=6.2832)

    CLASS = "touch_sensor"
    ACCEPTS = frozenset({"sampling"})
    FREE = frozenset({"bearing_rad", "angle_rad"})
    WIDTH = 1
    EXAMPLE = """
robots:
  Y1: {devices: {bumper: {device: touch_sensor, bearing_rad: 1.5708, angle_rad: 1}}}
"""

    def looks(self) -> tuple[float, float]:
        return self.bearing_rad, self.angle_rad

    def make_sensor(self, fitted: Fitted, context: SensorContext) -> Sensor:
        return TouchSensor(self, fitted, context)

    def describe(self) -> str:
        where = f", bearing {degrees(self.bearing_rad)}, {degrees(self.angle_rad)} wide"
        text = "1 if it touched a wall, an obstacle or a robot in the last tick, else 0"
        return f"bumper{where if self.angle_rad < math.tau - _AROUND else ' all around'}: {text}"


_AROUND = 1e-3


class TouchSensor(Sensor):
    """Reads 1 or 0."""

    def __init__(self, device: TouchSensorDevice, fitted: Fitted, context: SensorContext) -> None:
        super().__init__(fitted.spec)
        self._robot, self._joints = fitted.robot, context.joints
        self._bearing_rad, self._half_rad = device.bearing_rad, device.angle_rad / 2 + _AROUND

    def read(self, _tick: int, _pose: RobotPose, values: list[float]) -> None:
        off_rad = (
            math.remainder(bearing - self._bearing_rad, math.tau) for bearing in self._joints.touched_at(self._robot)
        )
        values[self.slot] = float(any(abs(off) <= self._half_rad for off in off_rad))
