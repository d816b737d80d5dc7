"""Rays for sensors: groups of geoms define what each may see. Parked things are out of reach of any ray."""

from __future__ import annotations

import math
from collections.abc import Iterable
from struct import Struct
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from rcj_challenges.devices.base import FixedRay
from rcj_challenges.devices.poses import NOMINAL_WITHIN_M, Vector
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.world import contact
from rcj_challenges.world.tables import one_by_one

if TYPE_CHECKING:
    from rcj_challenges.world.world import World

_FIELDS = (
    mujoco.mjtRayDataField.mjRAYDATA_DIST,
    mujoco.mjtRayDataField.mjRAYDATA_DIR,
    mujoco.mjtRayDataField.mjRAYDATA_NORMAL,
)
_RAY = Struct("7d")
"""Numbers of one rangefinder: distance, direction (3), the surface's normal (3)."""
_SENSORS_ON = ~int(mujoco.mjtDisableBit.mjDSBL_SENSOR)


def add_fixed_rays(spec: mujoco.MjSpec, rays: Iterable[FixedRay]) -> None:
    """Add rays to a model: a site and a rangefinder each, on the robot's body.

    The sensor stage is switched off in the model, because rays are needed once a tick and not in every sub-step; it is
    switched on while they are measured.
    """
    spec.option.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_SENSOR)
    for ray in rays:
        name = _name(ray.robot_name, ray.device_name)
        cos, sin = math.cos(ray.bearing_rad), math.sin(ray.bearing_rad)
        # A rangefinder looks along its site's z axis: a quarter turn about the horizontal normal to the bearing.
        spec.body(ray.robot_name).add_site(
            name=name,
            pos=[ray.offset_m * cos, ray.offset_m * sin, ray.above_centre_m],
            quat=[math.sqrt(0.5), -sin * math.sqrt(0.5), cos * math.sqrt(0.5), 0],
            size=[0.001, 0.001, 0.001],
            rgba=[0, 0, 0, 0],
        )
        rangefinder = spec.add_sensor(
            name=name,
            type=mujoco.mjtSensor.mjSENS_RANGEFINDER,
            objtype=mujoco.mjtObj.mjOBJ_SITE,
            objname=name,
        )
        rangefinder.intprm[0] = sum(1 << int(field) for field in _FIELDS)  # integers


def _name(robot_name: str, device_name: str) -> str:
    return f"{robot_name}/{device_name}"


class WorldRays:
    """The rays of all sensors of a half."""

    def __init__(self, scenario: Scenario, world: World) -> None:
        self._world = world
        self._tallest_m = max((2 * ball.radius_m for ball in scenario.balls.values()), default=0.0)
        self._thing_of_geom = world.tables.geom_things.tolist()
        self._groups = _flags((contact.GROUP_FIXTURES, contact.GROUP_CHASSIS, contact.GROUP_WHEELS))
        self._origin, self._along = np.zeros(3), np.zeros(3)
        geom: Any = np.zeros(1, np.int32)
        # Written and read number by number, which numpy takes longer for.
        self._origin_numbers, self._along_numbers = one_by_one(self._origin), one_by_one(self._along)
        self._geom, self._met = geom, memoryview(geom)

    def number_of(self, robot_name: str, device_name: str) -> int:
        """Return the number of a device's fixed ray."""
        return int(self._world.model.sensor(_name(robot_name, device_name)).id)

    def fixed(self, height_m: float) -> _FixedRays:
        """Return the fixed rays, for rays at this height."""
        return _FixedRays(self._world, self._seen_at(height_m))

    def fan(self, robot_name: str, height_m: float, max_m: float, rays: int) -> _Fan:
        """Return a fan of a robot at a height, which does not see that robot."""
        return _Fan(self._world, robot_name, _flags(self._seen_at(height_m)), max_m, rays)

    def reaches(self, robot: int, origin: Vector, along: Vector) -> bool:
        """Return whether a ray first meets this robot, or nothing; it passes through balls."""
        source, direction = self._origin_numbers, self._along_numbers
        source[0], source[1], source[2] = origin
        direction[0], direction[1], direction[2] = along
        world = self._world
        mujoco.mj_ray(world.model, world.data, self._origin, self._along, self._groups, 1, -1, self._geom)
        met = self._met[0]
        return met < 0 or self._thing_of_geom[met] == robot

    def _seen_at(self, height_m: float) -> tuple[int, ...]:
        """Return the groups of geoms that a horizontal ray at a height meets: fixtures and bodies, never wheels.

        Balls only where one is clearly taller than the ray: the lidar passes half a millimetre over the standard ball,
        and a hop must not make it appear.
        """
        balls = (contact.GROUP_BALLS,) if self._tallest_m > height_m + NOMINAL_WITHIN_M else ()
        return (contact.GROUP_FIXTURES, contact.GROUP_CHASSIS, *balls)


def _flags(groups: tuple[int, ...]) -> NDArray[np.uint8]:
    """Return groups as MuJoCo's rays want them: one flag for each of six."""
    return np.array([group in groups for group in range(6)], dtype=np.uint8)


class _FixedRays:
    """All rangefinders.

    They cannot select groups, but pass through transparent geoms: for a moment all others are made transparent.
    """

    def __init__(self, world: World, groups: tuple[int, ...]) -> None:
        self._model, self._data = world.model, world.data
        self._option = self._model.opt
        self._numbers = memoryview(self._data.sensordata).cast("B")
        self._colours = memoryview(self._model.geom_rgba).cast("B")
        self._usual = self._colours.tobytes()
        seen = np.isin(self._model.geom_group, groups)
        masked = self._model.geom_rgba.copy()
        masked[:, 3] = np.where(seen, np.maximum(masked[:, 3], np.float32(0.5)), np.float32(0))
        self._masked = masked.tobytes()

    def measure(self) -> list[tuple[float, ...]]:
        """Return distance in m, direction (3) and normal of what is met (3) of each ray; the normal of nothing is 0."""
        option = self._option
        flags = option.disableflags  # others use them too
        option.disableflags = flags & _SENSORS_ON
        self._colours[:] = self._masked
        mujoco.mj_sensorPos(self._model, self._data)
        self._colours[:] = self._usual
        option.disableflags = flags
        return list(_RAY.iter_unpack(self._numbers))


class _Fan:
    """Rays from one point, cast together."""

    def __init__(
        self, world: World, robot_name: str, groups: NDArray[np.uint8], max_m: float, rays: int
    ) -> None:  # fmt: skip
        self.origin = np.zeros(3)
        self.directions = np.zeros((rays, 3))
        self._model, self._data = world.model, world.data
        self._groups = groups
        self._max_m = max_m
        self._body = int(self._model.body(robot_name).id)
        self._geoms = np.zeros(rays, np.int32)
        self._distances = np.zeros(rays)

    def cast(self, count: int) -> NDArray[np.float64]:
        """Return the lengths of the first ``count`` rays in m (negative: nothing is met); overwritten next time."""
        distances = self._distances[:count]
        mujoco.mj_multiRay(
            self._model, self._data, self.origin, self.directions[:count].reshape(-1), self._groups, 1, self._body,
            self._geoms[:count], distances, None, count, self._max_m,
        )  # fmt: skip
        return distances
