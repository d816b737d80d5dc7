"""The device ``gps``."""

from collections.abc import Sequence
from typing import Literal, Self

from rcj_challenges.devices.base import Device, Fitted, Phrases, Reader, Sensor, SensorContext
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
    SENTENCE = "position of the robot (noise: standard deviation 1 cm)"

    def make_sensor(self, fitted: Fitted, context: SensorContext) -> Sensor:
        """Return the sensor of this device."""
        return GpsSensor(self, fitted, context)

    def describe(self, _phrases: Phrases) -> str:
        """Return what it is."""
        order = order_words(self.frame, ", given as [y, z, x]")
        return f"position of the robot{order}{noise_words(metres(self.noise_m) if self.noise_m else '')}"


class GpsSensor(Sensor):
    """The cube's centre in m: [x, y, z], or [y, z, x] in the legacy frame."""

    def __init__(self, device: GpsDevice, fitted: Fitted, context: SensorContext) -> None:
        super().__init__(fitted.spec)
        self.is_legacy = device.frame == "legacy"
        self._noise_m = device.noise_m
        self.noise = Noise.of(fitted, context.half, draws_per_tick=3) if device.noise_m else None

    @classmethod
    def reader(cls, sensors: Sequence[Self]) -> Reader:
        """Return what reads the sensors of a robot; the usual one has neither noise nor the legacy frame."""
        first, *others = sensors
        if others or first.noise is not None or first.is_legacy:
            return super().reader(sensors)
        slot = first.slot

        def read(_tick: int, pose: RobotPose, values: list[float]) -> None:
            values[slot], values[slot + 1], values[slot + 2] = pose.x, pose.y, pose.z

        return read

    def read(self, tick: int, pose: RobotPose, values: list[float]) -> None:
        """Write the sample of a tick into the robot's numbers."""
        x, y, z = pose.x, pose.y, pose.z
        if self.noise is not None:
            error_x, error_y, error_z = self.noise.numbers(tick)
            x, y, z = x + self._noise_m * error_x, y + self._noise_m * error_y, z + self._noise_m * error_z
        slot = self.slot
        values[slot], values[slot + 1], values[slot + 2] = (y, z, x) if self.is_legacy else (x, y, z)
