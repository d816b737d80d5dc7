"""The device ``compass``."""

import math
from typing import Literal

from rcj_challenges.devices.base import Device, Fitted, Sensor, SensorContext
from rcj_challenges.devices.noise import Noise
from rcj_challenges.devices.poses import RobotPose
from rcj_challenges.devices.wording import noise_words, order_words
from rcj_challenges.rules.fields import NotNegative, described
from rcj_challenges.rules.phrasing import degrees


class CompassDevice(Device):
    """The direction of north."""

    device: Literal["compass"]
    frame: Literal["field", "legacy"] = described("field", "field: [sin ψ, cos ψ, 0]; legacy: [cos θ, 0, sin θ]")
    noise_rad: NotNegative = described(0.0, "standard deviation of the heading in rad")

    CLASS = "compass"
    ACCEPTS = frozenset({"sampling"})
    WIDTH = 3
    RESOLUTION = 1e-4
    EXAMPLE = """
robots:
  Y1: {devices: {compass: {device: compass, noise_rad: 0.02}}}
"""

    def make_sensor(self, fitted: Fitted, context: SensorContext) -> Sensor:
        return CompassSensor(self, fitted, context)

    def describe(self) -> str:
        noise = noise_words(degrees(self.noise_rad) if self.noise_rad else "")
        return f"direction of north{order_words(self.frame, ', given as [left, up, ahead]')}{noise}"


class CompassSensor(Sensor):
    """The world's +y in the robot's frame: [sin ψ, cos ψ, 0], or [cos θ, 0, sin θ] in the legacy frame."""

    def __init__(self, device: CompassDevice, fitted: Fitted, context: SensorContext) -> None:
        super().__init__(fitted.spec)
        self._is_legacy = device.frame == "legacy"
        self._noise_rad = device.noise_rad
        self._noise = Noise.of(fitted, context.half) if device.noise_rad else None

    def read(self, tick: int, pose: RobotPose, values: list[float]) -> None:
        forward, left = pose.sin, pose.cos
        if self._noise is not None:
            forward, left = _turned(forward, left, self._noise_rad * self._noise.numbers(tick)[0])
        slot = self.slot
        shown = (left, 0.0, forward) if self._is_legacy else (forward, left, 0.0)
        values[slot], values[slot + 1], values[slot + 2] = shown


def _turned(forward: float, left: float, by_rad: float) -> tuple[float, float]:
    cos, sin = math.cos(by_rad), math.sin(by_rad)
    return forward * cos + left * sin, left * cos - forward * sin
