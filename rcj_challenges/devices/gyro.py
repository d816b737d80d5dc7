"""The device ``gyro``."""

from typing import Literal

from rcj_challenges.devices.base import Device, Fitted, Sensor, SensorContext
from rcj_challenges.devices.noise import Noise, drawn_once
from rcj_challenges.devices.poses import RobotPose
from rcj_challenges.devices.wording import noise_words
from rcj_challenges.rules.fields import NotNegative, described
from rcj_challenges.rules.phrasing import degrees


class GyroDevice(Device):
    """How fast the robot turns: [0, 0, rad/s], counter-clockwise."""

    device: Literal["gyro"]
    noise_radps: NotNegative = described(0.0, "standard deviation in rad/s", le=10)
    drift_radps: NotNegative = described(
        0.0, "standard deviation in rad/s of what it reads too much all through a half; drawn for each", le=1
    )

    CLASS = "gyro"
    ACCEPTS = frozenset({"sampling"})
    WIDTH = 3
    EXAMPLE = """
robots:
  Y1: {devices: {gyro: {device: gyro, noise_radps: 0.02, drift_radps: 0.005}}}
"""

    def make_sensor(self, fitted: Fitted, context: SensorContext) -> Sensor:
        return GyroSensor(self, fitted, context)

    def describe(self) -> str:
        noise = noise_words(f"{degrees(self.noise_radps)} a second" if self.noise_radps else "")
        if self.drift_radps:
            drift = f"in each half it reads too much by an amount of standard deviation {degrees(self.drift_radps)}"
            noise = f"{noise.removesuffix(')')}; {drift} a second)" if noise else f" ({drift} a second)"
        return f"how fast the robot turns in rad/s{noise}"


class GyroSensor(Sensor):
    """The turning of a robot that stands on the floor."""

    def __init__(self, device: GyroDevice, fitted: Fitted, context: SensorContext) -> None:
        super().__init__(fitted.spec)
        self._robot, self._joints = fitted.robot, context.joints
        self._noise_radps = device.noise_radps
        self._noise = Noise.of(fitted, context.half)
        self._drift_radps = device.drift_radps * drawn_once(fitted, context.half) if device.drift_radps else 0.0

    def read(self, tick: int, _pose: RobotPose, values: list[float]) -> None:
        noise_radps = self._noise_radps * self._noise.numbers(tick)[0] if self._noise_radps else 0.0
        turning_radps = self._joints.velocity(self._robot)[2] + self._drift_radps + noise_radps
        values[self.slot : self.slot + 3] = 0.0, 0.0, turning_radps
