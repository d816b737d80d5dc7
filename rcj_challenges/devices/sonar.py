"""Sonars: horizontal rays that find the nearest wall, goal or robot.

All rays of all robots are MuJoCo rangefinders, so that one call measures them all. They see the boxes of the field,
obstacles and robots' cubes; never what the rule book's sonar passes over: balls and wheels.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import cast

import mujoco
import numpy as np
from numpy.typing import NDArray

from rcj_challenges.devices.body_sensors import Values
from rcj_challenges.devices.fitting import Fitted, fit
from rcj_challenges.devices.ground import Ground
from rcj_challenges.devices.noise import Noise
from rcj_challenges.devices.poses import Poses
from rcj_challenges.devices.sampling import Schedule
from rcj_challenges.devices.sight import RayMask, groups_at
from rcj_challenges.facts.play import HalfInfo
from rcj_challenges.scenario.models.robots import SonarDevice
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster

_FIELDS = (
    mujoco.mjtRayDataField.mjRAYDATA_DIST,
    mujoco.mjtRayDataField.mjRAYDATA_DIR,
    mujoco.mjtRayDataField.mjRAYDATA_NORMAL,
)
_WIDTH = 7
"""Numbers of one rangefinder: distance, direction (3), the surface's normal (3)."""

_MM_PER_M = 1000.0
_GRAZING = 1e-6
"""Cosine of the flattest echo there is, also where a scenario says that none is ever lost (`lost_from_rad` ≥ π / 2)."""

_NOISE_FULL_FROM_M = 1.0
"""The noise grows with the distance up to here. Source: reference, 4.1."""


def _site_name(one: Fitted) -> str:
    return f"{one.robot_name}/{one.spec.name}"


def device_sites(scenario: Scenario, roster: Roster) -> Callable[[mujoco.MjSpec], None]:
    """Return what adds the sonars to a model: a site and a rangefinder each, on the robot's body.

    The sensor stage is switched off in the model, for the rays are wanted once a tick and not in every sub-step;
    `Sonars` switches it on while it measures.
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


class _Places:
    """Where the readings are written."""

    def __init__(self, fitted: Sequence[Fitted]) -> None:
        """Find runs of sensors of one robot whose slots follow each other: those are written at once."""
        self._slots = [(one.robot, one.spec.slot) for one in fitted]
        self._runs: list[tuple[int, int, int, int, int]] = []
        for member, (robot, slot) in enumerate(self._slots):
            if self._runs and self._runs[-1][0] == robot and self._runs[-1][2] == slot:
                _, first_slot, _, first, _ = self._runs[-1]
                self._runs[-1] = (robot, first_slot, slot + 1, first, member + 1)
            else:
                self._runs.append((robot, slot, slot + 1, member, member + 1))

    def write(self, values: Values, readings: list[float], due: Sequence[int]) -> None:
        """Write the readings (of all members) of those that are due."""
        if len(due) == len(self._slots):
            for robot, first_slot, end_slot, first, end in self._runs:
                values[robot][first_slot:end_slot] = readings[first:end]
        else:
            for member in due:
                robot, slot = self._slots[member]
                values[robot][slot] = readings[member]


class Sonars:
    """All sonars of all robots: v = 1000·d below the range, else the out-of-range value, times the noise."""

    def __init__(
        self, fitted: Sequence[Fitted], scenario: Scenario, ground: Ground, half: HalfInfo
    ) -> None:  # fmt: skip
        """Find the rangefinders that `device_sites` added, in the same order."""
        self.schedule = Schedule()
        devices = [cast("SonarDevice", one.device) for one in fitted]
        count = len(fitted)
        self._model: mujoco.MjModel = ground.model
        self._data: mujoco.MjData = ground.data
        first = int(self._model.sensor(_site_name(fitted[0])).adr[0])
        self._rays: NDArray[np.float64] = self._data.sensordata[first : first + _WIDTH * count].reshape(count, _WIDTH)
        self._limits = [(device.range_m, -max(_GRAZING, math.cos(device.lost_from_rad))) for device in devices]
        shares = np.array([device.noise for device in devices])
        self._noise = Noise(half, [(one.robot_name, one.spec.name) for one in fitted], scale=_MM_PER_M * shares)
        self._places = _Places(fitted)
        self._mask = RayMask(ground, groups_at(scenario, min(device.height_m for device in devices)))
        self._option = self._model.opt
        self._sensors_on = int(self._model.opt.disableflags) & ~int(mujoco.mjtDisableBit.mjDSBL_SENSOR)
        self._sensors_off = int(self._model.opt.disableflags)

    def sample(self, tick: int, _poses: Poses, values: Values) -> None:
        """Read the sonars that are due at ``tick``."""
        due = self.schedule.due(tick)
        if not due:
            return
        self._measure()
        self._places.write(values, self._readings(tick), due)

    def _measure(self) -> None:
        option = self._option
        option.disableflags = self._sensors_on
        self._mask.hide()
        mujoco.mj_sensorPos(self._model, self._data)
        self._mask.show()
        option.disableflags = self._sensors_off

    def _readings(self, tick: int) -> list[float]:
        readings: list[float] = []
        # Number by number: for two dozen of them numpy's calls cost more than they save.
        rays, noise = self._rays.tolist(), self._noise.row(tick).tolist()
        for (distance, dx, dy, dz, nx, ny, nz), (range_m, heard_below), error in zip(
            rays, self._limits, noise, strict=True
        ):
            # Cosine of the angle between ray and normal, -1 head on. Nothing hit: the normal is zero, not heard.
            facing = dx * nx + dy * ny + dz * nz
            echo_m = min(distance, range_m) if facing < heard_below else range_m
            if facing > 0:  # only a ray that begins inside a body pressed against the robot: an echo from no distance
                echo_m = 0.0
            readings.append(echo_m * (_MM_PER_M + min(echo_m, _NOISE_FULL_FROM_M) * error))
        return readings
