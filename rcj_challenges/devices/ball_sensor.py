"""The device ``ball_sensor``: a light barrier at the robot's front."""

from typing import Any, Literal

from rcj_challenges.chassis.base import is_at_front
from rcj_challenges.devices.base import Device, Fitted, RobotSetup, Sensor, SensorContext
from rcj_challenges.devices.poses import RobotPose
from rcj_challenges.rules.fields import Positive, described
from rcj_challenges.rules.phrasing import metres

_MM_PER_M = 1000.0


class BallSensorDevice(Device):
    """How near a ball is to the middle of the robot's front, as a distance sensor that sees nothing else."""

    device: Literal["ball_sensor"]
    range_m: Positive = described(0.02, "greatest distance from the front to the ball in m", le=0.1)

    CLASS = "distance_sensor"
    ACCEPTS = frozenset({"sampling"})
    WIDTH = 1
    RESOLUTION = 0.1
    EXAMPLE = """
robots:
  Y1: {devices: {ball sensor: {device: ball_sensor, range_m: 0.01}}}
"""

    def facts(self, _setup: RobotSetup) -> dict[str, Any]:
        reach = _MM_PER_M * self.range_m
        return {"min_value": 0.0, "max_value": reach, "bearing_rad": 0.0, "type": "infra-red"}

    def make_sensor(self, fitted: Fitted, context: SensorContext) -> Sensor:
        return BallSensor(self, fitted, context)

    def describe(self) -> str:
        return (
            "light barrier: how far a ball is from the middle of the robot's front, within 2 cm to its sides, up to "
            f"{metres(self.range_m)}"
        )


class BallSensor(Sensor):
    """1000 times the gap in m, at most the range."""

    def __init__(self, device: BallSensorDevice, fitted: Fitted, context: SensorContext) -> None:
        super().__init__(fitted.spec)
        self._joints, self._range_m = context.joints, device.range_m
        self._front_m = fitted.setup.chassis.front_m

    def read(self, _tick: int, pose: RobotPose, values: list[float]) -> None:
        nearest_m, front_m = self._range_m, self._front_m
        for (x, y, z), radius_m in zip(self._joints.balls, self._joints.radii_m, strict=True):
            ahead_m, aside_m, _ = pose.to_frame(x - pose.x, y - pose.y, 0.0)
            if z < 2 * radius_m and is_at_front(front_m, ahead_m, aside_m, radius_m, nearest_m):
                nearest_m = max(0.0, ahead_m - front_m - radius_m)
        values[self.slot] = _MM_PER_M * nearest_m
