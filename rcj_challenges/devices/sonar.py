"""The device ``sonar``.

The rays of all robots are measured in one call. They see the boxes of the field, obstacles and robots' cubes; never
what the rule book's sonar passes over: balls and wheels.
"""

import math
from collections.abc import Sequence
from typing import Any, Literal, Self, cast

from rcj_challenges.devices.base import Device, Fitted, FixedRay, Reader, RobotSetup, Sensor, SensorContext
from rcj_challenges.devices.noise import Noise
from rcj_challenges.devices.poses import RobotPose, Vector
from rcj_challenges.devices.wording import noise_words, percent_words
from rcj_challenges.rules.fields import NotNegative, Positive, described
from rcj_challenges.rules.phrasing import degrees, metres

NOISE_FULL_FROM_M = 1.0
"""Up to here the share of a sonar's noise grows with the distance. Source: reference, 4.1."""

_MM_PER_M = 1000.0
_GRAZING = 1e-6
"""Cosine of the flattest echo there is, also if a scenario says that none is ever lost (`lost_from_rad` ≥ π / 2)."""


class SonarDevice(Device):
    """A distance sensor: one horizontal ray. The defaults are those of the original's robots."""

    # Their source: reference, section 4.1.

    device: Literal["sonar"]
    bearing_rad: float = described(..., "direction in the robot's frame in rad; 0 front, 1.5708 left (+y)")
    offset_m: NotNegative = described(
        0.0385, "distance from the robot's centre to the start of the ray, along the bearing, in m"
    )
    height_m: Positive = described(0.0575, "height of the ray above the floor in m")
    range_m: Positive = described(1.0, "range in m; beyond it, the reading is the out-of-range value", le=20)
    noise: NotNegative = described(
        0.05, "standard deviation as a share of the reading at 1 m and beyond; proportionally less at shorter distances"
    )
    lost_from_rad: Positive = described(
        0.3927, "smallest angle to the surface's normal at which no echo returns, in rad"
    )

    CLASS = "distance_sensor"
    ACCEPTS = frozenset({"sampling"})
    FREE = frozenset({"bearing_rad", "offset_m", "height_m"})
    WIDTH = 1
    RESOLUTION = 0.1
    PAGE_FACTS = ("bearing_rad", "max_value")
    EXAMPLE = """
robots:
  Y1:
    without: [distancesensor back]
    devices:
      distancesensor front left: {device: sonar, bearing_rad: 0.7854, range_m: 0.5}
"""

    def place(self) -> Vector:
        return self.offset_m * math.cos(self.bearing_rad), self.offset_m * math.sin(self.bearing_rad), self.height_m

    def looks(self) -> tuple[float, float]:
        return self.bearing_rad, 0.0

    def facts(self, _setup: RobotSetup) -> dict[str, Any]:
        return {"min_value": 0.0, "max_value": 1000.0 * self.range_m, "bearing_rad": self.bearing_rad}

    def fixed_ray(self, robot_name: str, name: str, setup: RobotSetup) -> FixedRay:
        return FixedRay(robot_name, name, self.bearing_rad, self.offset_m, self.height_m - setup.chassis.height_m / 2)

    @classmethod
    def make_sensors(cls, fitted: Sequence[Fitted], context: SensorContext) -> "Sequence[SonarSensor]":
        echoes = Echoes(fitted, context)
        return [SonarSensor(number, one, echoes, context) for number, one in enumerate(fitted)]

    def describe(self) -> str:
        noise = noise_words(percent_words(self.noise, "the value from 1 m on, less when nearer"))
        if self.noise and self.range_m < NOISE_FULL_FROM_M:
            # It never measures as far as where the noise stops growing: the figure that holds is that of its own range.
            full = percent_words(self.noise * self.range_m, f"the value at {metres(self.range_m)}")
            noise = noise_words(f"{full}, less when nearer: at half the distance half that share")
        where = f"{metres(self.offset_m)} off the robot's centre and {metres(self.height_m)} above the floor"
        # At a right angle and more a ray meets nothing.
        lost = f", without an echo of what it meets at {degrees(self.lost_from_rad)} or more off the perpendicular"
        return (
            f"distance sensor, bearing {degrees(self.bearing_rad)}, up to {metres(self.range_m)}{noise}, {where}"
            f"{lost if self.lost_from_rad < math.pi / 2 else ''}"
        )


class Echoes:
    """Distance, direction and normal of all rays, and noise, measured once in a tick in which a sonar is read."""

    def __init__(self, fitted: Sequence[Fitted], context: SensorContext) -> None:
        import numpy as np

        devices = [cast("SonarDevice", one.device) for one in fitted]
        scale = _MM_PER_M * np.array([device.noise for device in devices])
        self._noise = Noise(context.half, [(one.robot_name, one.spec.name) for one in fitted], scale=scale)
        self._fixed = context.rays.fixed(min(device.height_m for device in devices))
        self.tick = -1
        self.rays: list[tuple[float, ...]] = []
        self.errors: list[float] = []

    def measure(self, tick: int) -> None:
        self.tick = tick
        self.rays = self._fixed.measure()
        self.errors = self._noise.numbers(tick)


class SonarSensor(Sensor):
    """One sonar: v = 1000·d below the range, else the out-of-range value, times the noise.

    Attributes:
        echoes: of all sonars.
        row: its ray, its number among the sonars, its slot, its range in m, and the cosine of ray and normal from which
            on no echo comes back.
    """

    __slots__ = ("echoes", "row")

    def __init__(self, number: int, fitted: Fitted, echoes: Echoes, context: SensorContext) -> None:
        super().__init__(fitted.spec)
        device = cast("SonarDevice", fitted.device)
        ray = context.rays.number_of(fitted.robot_name, fitted.spec.name)
        self.echoes = echoes
        self.row = (ray, number, self.slot, device.range_m, -max(_GRAZING, math.cos(device.lost_from_rad)))

    @classmethod
    def reader(cls, sensors: Sequence[Self]) -> Reader:
        echoes, rows = sensors[0].echoes, [sensor.row for sensor in sensors]
        full_from_m, mm_per_m = NOISE_FULL_FROM_M, _MM_PER_M

        def read(tick: int, _pose: RobotPose, values: list[float]) -> None:
            if echoes.tick != tick:
                echoes.measure(tick)
            rays, errors = echoes.rays, echoes.errors
            # Number by number: for a handful of them numpy's calls cost more than they save.
            for ray, number, slot, range_m, facing_below in rows:
                distance, dx, dy, dz, nx, ny, nz = rays[ray]
                # Cosine of the angle between ray and normal, -1 head on. Nothing hit: the normal is zero, no echo.
                facing = dx * nx + dy * ny + dz * nz
                if facing < facing_below:
                    echo_m = distance if distance < range_m else range_m  # noqa: FURB136 - `min` takes twice as long
                else:
                    # A ray leaves a body only if it begins in one that is pressed against the robot: no distance.
                    echo_m = 0.0 if facing > 0 else range_m
                full_m = echo_m if echo_m < full_from_m else full_from_m  # noqa: FURB136
                values[slot] = echo_m * (mm_per_m + full_m * errors[number])

        return read
