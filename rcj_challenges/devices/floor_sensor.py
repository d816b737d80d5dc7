"""The device ``floor_sensor``: how bright the floor is under a place of the robot."""

from typing import Any, Literal

from rcj_challenges.devices.base import Device, Fitted, RobotSetup, Sensor, SensorContext
from rcj_challenges.devices.noise import Noise
from rcj_challenges.devices.poses import RobotPose, Vector
from rcj_challenges.devices.wording import noise_words, percent_words
from rcj_challenges.rules.fields import NotNegative, described
from rcj_challenges.rules.phrasing import metres


class FloorSensorDevice(Device):
    """How bright the floor is under a place of the robot, from 0 (black) to 1000 (white lines)."""

    device: Literal["floor_sensor"]
    ahead_m: float = described(0.0, "how far ahead of the robot's centre it is in m")
    left_m: float = described(0.0, "how far left of the robot's centre it is in m")
    noise: NotNegative = described(0.0, "standard deviation as a share of the reading", le=1)

    CLASS = "light_sensor"
    ACCEPTS = frozenset({"sampling"})
    FREE = frozenset({"ahead_m", "left_m"})
    WIDTH = 1
    RESOLUTION = 0.1
    EXAMPLE = """
robots:
  Y1: {devices: {floor sensor: {device: floor_sensor, ahead_m: 0.03, noise: 0.05}}}
"""

    def place(self) -> Vector:
        return self.ahead_m, self.left_m, 0.0

    def facts(self, _setup: RobotSetup) -> dict[str, Any]:
        return {"max_value": 1000.0}

    def make_sensor(self, fitted: Fitted, context: SensorContext) -> Sensor:
        return FloorSensor(self, fitted, context)

    def describe(self) -> str:
        return (
            f"brightness of the floor from 0 to 1000, {metres(self.ahead_m)} ahead and {metres(self.left_m)} left of "
            f"the robot's centre{noise_words(percent_words(self.noise, 'the value'))}"
        )


class FloorSensor(Sensor):
    """The brightness of the colours in which cameras see the floor."""

    def __init__(self, device: FloorSensorDevice, fitted: Fitted, context: SensorContext) -> None:
        super().__init__(fitted.spec)
        self._device, self._floor = device, context.make_sight()
        self._noise = Noise.of(fitted, context.half)

    def read(self, tick: int, pose: RobotPose, values: list[float]) -> None:
        ahead_m, left_m, cos, sin = self._device.ahead_m, self._device.left_m, pose.cos, pose.sin
        bright = self._floor.brightness(pose.x + cos * ahead_m - sin * left_m, pose.y + sin * ahead_m + cos * left_m)
        error = self._device.noise * self._noise.numbers(tick)[0] if self._device.noise else 0.0
        values[self.slot] = max(0.0, 1000.0 * bright * (1 + error))
