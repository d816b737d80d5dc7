"""Sonars: horizontal rays that find the nearest wall, goal or robot.

All rays of all robots are MuJoCo rangefinders, so that one call measures them all. They see the boxes of the field,
obstacles and robots' cubes; never what the rule book's sonar passes over: balls and wheels.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from struct import Struct
from typing import cast

import mujoco
import numpy as np

from rcj_challenges.devices.fitting import Fitted, fit
from rcj_challenges.devices.ground import Ground
from rcj_challenges.devices.noise import Noise
from rcj_challenges.devices.sight import RayMask, groups_at
from rcj_challenges.facts.play import HalfInfo
from rcj_challenges.scenario.models.robots import SONAR_NOISE_FULL_FROM_M, SonarDevice
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster

_FIELDS = (
    mujoco.mjtRayDataField.mjRAYDATA_DIST,
    mujoco.mjtRayDataField.mjRAYDATA_DIR,
    mujoco.mjtRayDataField.mjRAYDATA_NORMAL,
)
_NUMBERS = 7
_RAY = Struct(f"{_NUMBERS}d")
"""Numbers of one rangefinder: distance, direction (3), the surface's normal (3)."""

_SENSORS_ON = ~int(mujoco.mjtDisableBit.mjDSBL_SENSOR)
_MM_PER_M = 1000.0
_GRAZING = 1e-6
"""Cosine of the flattest echo there is, also where a scenario says that none is ever lost (`lost_from_rad` ≥ π / 2)."""


def _site_name(one: Fitted) -> str:
    return f"{one.robot_name}/{one.spec.name}"


def device_sites(scenario: Scenario, roster: Roster) -> Callable[[mujoco.MjSpec], None]:
    """Return what adds the sonars to a model: a site and a rangefinder each, on the robot's body.

    The sensor stage is switched off in the model, for the rays are wanted once a tick and not in every sub-step;
    `Echoes` switches it on while it measures.
    """
    sonars = [one for one in fit(scenario, roster) if isinstance(one.device, SonarDevice)]

    def extend(spec: mujoco.MjSpec) -> None:
        spec.option.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_SENSOR)
        for one in sonars:
            sonar = cast("SonarDevice", one.device)
            kit = scenario.kits[scenario.robots[one.robot_name].kit]
            cos, sin = math.cos(sonar.bearing_rad), math.sin(sonar.bearing_rad)
            # A rangefinder looks along its site's z axis: a quarter turn about the horizontal normal to the bearing.
            spec.body(one.robot_name).add_site(
                name=_site_name(one),
                pos=[sonar.offset_m * cos, sonar.offset_m * sin, sonar.height_m - kit.chassis.size_m / 2],
                quat=[math.sqrt(0.5), -sin * math.sqrt(0.5), cos * math.sqrt(0.5), 0],
                size=[0.001, 0.001, 0.001],
                rgba=[0, 0, 0, 0],
            )
            rangefinder = spec.add_sensor(
                name=_site_name(one),
                type=mujoco.mjtSensor.mjSENS_RANGEFINDER,
                objtype=mujoco.mjtObj.mjOBJ_SITE,
                objname=_site_name(one),
            )
            rangefinder.intprm[0] = sum(1 << int(field) for field in _FIELDS)

    return extend


Sonar = tuple[int, int, float, float]
"""One sonar: its ray, the slot of its own, its range in m, and the cosine of ray and normal below which it hears.

A plain tuple: Python takes twice as long to unpack a named one, and does so for two dozen at every tick.
"""


class Echoes:
    """All sonars of all robots: v = 1000·d below the range, else the out-of-range value, times the noise.

    Attributes:
        sonars: by robot and index of the device.
    """

    def __init__(self, fitted: Sequence[Fitted], scenario: Scenario, ground: Ground, half: HalfInfo) -> None:
        """Find the rangefinders that `device_sites` added, in the same order; there is at least one."""
        devices = [cast("SonarDevice", one.device) for one in fitted]
        self._model: mujoco.MjModel = ground.model
        self._data: mujoco.MjData = ground.data
        first = int(self._model.sensor(_site_name(fitted[0])).adr[0])
        self._numbers = memoryview(self._data.sensordata[first : first + _NUMBERS * len(fitted)]).cast("B")
        self._rays: list[tuple[float, ...]] = []
        shares = np.array([device.noise for device in devices])
        self._noise = Noise(half, [(one.robot_name, one.spec.name) for one in fitted], scale=_MM_PER_M * shares)
        self.sonars = {
            (one.robot, one.spec.index): (
                ray,
                one.spec.slot,
                device.range_m,
                -max(_GRAZING, math.cos(device.lost_from_rad)),
            )
            for ray, (one, device) in enumerate(zip(fitted, devices, strict=True))
        }
        self._errors: list[float] = []
        self._mask = RayMask(ground, groups_at(scenario, min(device.height_m for device in devices)))
        self._option = self._model.opt

    def measure(self, tick: int) -> None:
        """Measure all rays; `read` makes readings of them."""
        option = self._option
        flags = option.disableflags  # others use them as well
        option.disableflags = flags & _SENSORS_ON
        self._mask.hide()
        mujoco.mj_sensorPos(self._model, self._data)
        self._mask.show()
        option.disableflags = flags
        self._rays = list(_RAY.iter_unpack(self._numbers))
        self._errors = self._noise.numbers(tick)

    def read(self, sonars: Sequence[Sonar], values: list[float]) -> None:
        """Write the readings of some sonars of a robot into its numbers."""
        rays, errors = self._rays, self._errors
        full_from_m, mm_per_m = SONAR_NOISE_FULL_FROM_M, _MM_PER_M
        # Number by number: for a handful of them numpy's calls cost more than they save.
        for ray, slot, range_m, heard_below in sonars:
            distance, dx, dy, dz, nx, ny, nz = rays[ray]
            # Cosine of the angle between ray and normal, -1 head on. Nothing hit: the normal is zero, not heard.
            facing = dx * nx + dy * ny + dz * nz
            if facing < heard_below:
                echo_m = distance if distance < range_m else range_m  # noqa: FURB136 - `min` takes twice as long
            else:
                # A ray leaves a body only if it begins in one that is pressed against the robot: echo from no distance.
                echo_m = 0.0 if facing > 0 else range_m
            values[slot] = echo_m * (mm_per_m + (echo_m if echo_m < full_from_m else full_from_m) * errors[ray])  # noqa: FURB136
