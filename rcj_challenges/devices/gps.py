"""The device ``gps``."""

from typing import Literal

from rcj_challenges.devices.base import Device, Fitted, Sensor, SensorContext
from rcj_challenges.devices.noise import Noise
from rcj_challenges.devices.poses import RobotPose
from rcj_challenges.devices.wording import noise_words, order_words
from rcj_challenges.rules.fields import NotNegative, described
from rcj_challenges.rules.phrasing import metres


class GpsDevice(Device):
    """The position of the cube's centre."""

    device: Literal["gps"]
    frame: Literal["field", "legacy"] = described("field", "field: [x, y, z]; legacy: [y, z, x] as in the 2021 worlds")
    noise_m: NotNegative = described(0.0, "standard deviation of each coordinate in m")

    CLASS = "gps"
    ACCEPTS = frozenset({"sampling"})
    WIDTH = 3
    RESOLUTION = 1e-4
    EXAMPLE = """
robots:
  Y1: {devices: {gps: {device: gps, noise_m: 0.01}}}
"""

    def make_sensor(self, fitted: Fitted, context: SensorContext) -> Sensor:
        return GpsSensor(self, fitted, context)

    def describe(self) -> str:
        order = order_words(self.frame, ", given as [y, z, x]")
        return f"position of the robot{order}{noise_words(metres(self.noise_m) if self.noise_m else '')}"


class GpsSensor(Sensor):
    """The cube's centre in m: [x, y, z], or [y, z, x] in the legacy frame."""

    def __init__(self, device: GpsDevice, fitted: Fitted, context: SensorContext) -> None:
        super().__init__(fitted.spec)
        self._is_legacy = device.frame == "legacy"
        self._noise_m = device.noise_m
        self._noise = Noise.of(fitted, context.half, draws_per_tick=3) if device.noise_m else None

    def read(self, tick: int, pose: RobotPose, values: list[float]) -> None:
        x, y, z = pose.x, pose.y, pose.z
        if self._noise is not None:
            error_x, error_y, error_z = self._noise.numbers(tick)
            x, y, z = x + self._noise_m * error_x, y + self._noise_m * error_y, z + self._noise_m * error_z
        slot = self.slot
        values[slot], values[slot + 1], values[slot + 2] = (y, z, x) if self._is_legacy else (x, y, z)
