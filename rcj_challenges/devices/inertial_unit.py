"""The device ``inertial_unit``."""

import math
from typing import Any, Literal

from rcj_challenges.core.timing import TICK_S
from rcj_challenges.devices.base import Device, Fitted, RobotSetup, Sensor, SensorContext
from rcj_challenges.devices.noise import Noise, drawn_once
from rcj_challenges.devices.poses import RobotPose
from rcj_challenges.devices.wording import noise_words
from rcj_challenges.rules.fields import NotNegative, described
from rcj_challenges.rules.phrasing import degrees


class InertialUnitDevice(Device):
    """Roll, pitch and yaw of the robot in rad; the yaw is 0 along +x and grows counter-clockwise."""

    device: Literal["inertial_unit"]
    noise_rad: NotNegative = described(0.0, "standard deviation of the yaw in rad")
    drift_radps: NotNegative = described(
        0.0,
        "standard deviation of the speed in rad/s with which the yaw drifts all through a half; drawn for each",
        le=1,
    )

    CLASS = "inertial_unit"
    ACCEPTS = frozenset({"sampling"})
    WIDTH = 3
    RESOLUTION = 1e-4
    EXAMPLE = """
robots:
  Y1: {devices: {inertial unit: {device: inertial_unit, noise_rad: 0.01, drift_radps: 0.001}}}
"""

    def facts(self, _setup: RobotSetup) -> dict[str, Any]:
        return {"noise": self.noise_rad}

    def make_sensor(self, fitted: Fitted, context: SensorContext) -> Sensor:
        return InertialUnitSensor(self, fitted, context)

    def describe(self) -> str:
        yaw = f"{degrees(self.noise_rad)} of the yaw" if self.noise_rad else ""
        drift = f"{degrees(self.drift_radps)} a second of its drift" if self.drift_radps else ""
        return f"roll, pitch and yaw in rad{noise_words(yaw, drift)}"


class InertialUnitSensor(Sensor):
    """Roll and pitch are 0: robots cannot tip (ADR 2)."""

    def __init__(self, device: InertialUnitDevice, fitted: Fitted, context: SensorContext) -> None:
        super().__init__(fitted.spec)
        self._noise_rad = device.noise_rad
        self._noise = Noise.of(fitted, context.half)
        self._drift_radps = device.drift_radps * drawn_once(fitted, context.half) if device.drift_radps else 0.0

    def read(self, tick: int, pose: RobotPose, values: list[float]) -> None:
        error_rad = self._noise_rad * self._noise.numbers(tick)[0] if self._noise_rad else 0.0
        yaw = math.remainder(pose.yaw + self._drift_radps * tick * TICK_S + error_rad, math.tau)
        values[self.slot : self.slot + 3] = 0.0, 0.0, yaw
