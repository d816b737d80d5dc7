"""Laser scanners: a ring of rays, all at once or a part of the turn each tick."""

from __future__ import annotations

import math
from typing import NamedTuple, cast

import mujoco
import numpy as np
from numpy.typing import NDArray

from rcj_challenges.devices.fitting import Fitted, lidar_bearings
from rcj_challenges.devices.ground import Ground
from rcj_challenges.devices.noise import Noise
from rcj_challenges.devices.poses import RobotPose
from rcj_challenges.devices.sight import as_geomgroup, groups_at
from rcj_challenges.facts.play import HalfInfo
from rcj_challenges.facts.timing import TICK_S
from rcj_challenges.scenario.models.robots import LidarDevice
from rcj_challenges.scenario.models.scenario import Scenario

NOT_YET_SWEPT = 0.0
"""What a cell holds that the rays have not reached yet. Source: reference, 4.2."""


_REMEMBERED = 1_000
"""Sectors of a turning head; at 10 Hz there are 25."""


class Sector(NamedTuple):
    """Cells of a ring: which, and the parts of their rays along the robot's +x and +y."""

    cells: slice | NDArray[np.intp]
    forward: NDArray[np.float64]
    left: NDArray[np.float64]


class Lidar:
    """One scanner. Its plane is level at its height while the robot stands, and tilts with a robot that lies."""

    def __init__(self, fitted: Fitted, scenario: Scenario, ground: Ground, half: HalfInfo) -> None:
        """Lay out the ring of rays in the robot's frame."""
        device = cast("LidarDevice", fitted.device)
        self.slot = fitted.spec.slot
        self.device = device
        self.cells: NDArray[np.float32] = np.full(device.points, NOT_YET_SWEPT, np.float32)
        self._bounds_hz = (fitted.spec.facts["min_frequency"], fitted.spec.facts["max_frequency"])
        self._frequency_hz = device.frequency_hz
        self._turns = 0.0
        self._passed: dict[tuple[float, float], Sector] = {}
        first_rad, step_rad = lidar_bearings(device)
        bearings = first_rad + step_rad * np.arange(device.points)
        self._forward = np.cos(bearings)
        self._left = np.sin(bearings)
        self._whole = Sector(slice(None), self._forward, self._left)
        # Where in its clockwise turn from the front the head passes each cell, in turns.
        self._passed_at = (-bearings / (2 * math.pi)) % 1.0
        chassis = scenario.kits[scenario.robots[fitted.robot_name].kit].chassis
        self._above_centre_m = device.height_m - chassis.size_m / 2
        self._groups = as_geomgroup(groups_at(scenario, device.height_m))
        self._noise = Noise(half, [(fitted.robot_name, fitted.spec.name)], device.points) if device.noise_m else None
        self._model = ground.model
        self._data = ground.data
        self._body = int(ground.model.body(fitted.robot_name).id)
        self._origin = np.zeros(3)
        self._rays = np.zeros((device.points, 3))
        self._geoms = np.zeros(device.points, np.int32)
        self._distances = np.zeros(device.points)

    def clear(self) -> None:
        """Forget all readings and begin the turn at the front."""
        self.cells[:] = NOT_YET_SWEPT
        self._turns = 0.0

    def set_frequency(self, frequency_hz: float) -> None:
        """Set how fast the head turns, within its bounds."""
        if math.isfinite(frequency_hz):
            lowest, highest = self._bounds_hz
            self._frequency_hz = min(highest, max(lowest, frequency_hz))

    def read(self, tick: int, pose: RobotPose, values: list[float]) -> None:
        """Write all cells into the robot's numbers: as they are, if the head turns; else measured now."""
        if not self.device.rotating:
            self.measure(tick, pose)
        values[self.slot : self.slot + self.device.points] = self.cells.tolist()

    def turn(self, tick: int, pose: RobotPose) -> None:
        """Refresh the cells that a rotating head passes in one tick."""
        begin, forth = self._turns, self._frequency_hz * TICK_S  # less than a turn: at most 31 Hz
        # Rounded, so that a head that comes back to the same place is seen to be there.
        self._turns = round(begin + forth, 12) % 1.0
        sector = self._passed.get((begin, forth))
        if sector is None:
            sector = self._sector(begin, forth)
        self.measure(tick, pose, sector)

    def _sector(self, begin: float, forth: float) -> Sector:
        """Return the cells that the head passes from one place on, in turns; remembered, for it passes them again."""
        # Rounded to a billionth of a turn: whether a cell is passed must not hang on the last bit of a sum.
        since = np.round((self._passed_at - begin) % 1.0, 9) % 1.0
        cells = np.flatnonzero(since < round(forth, 9))
        if len(self._passed) >= _REMEMBERED:
            self._passed.clear()
        sector = self._passed[begin, forth] = Sector(cells, self._forward[cells], self._left[cells])
        return sector

    def measure(self, tick: int, pose: RobotPose, sector: Sector | None = None) -> None:
        """Measure some cells, or all of them (None)."""
        chosen, forward, left = sector or self._whole
        count = len(forward)
        self._aim(pose, forward, left, count)
        distances = self._distances[:count]
        mujoco.mj_multiRay(
            self._model, self._data, self._origin, self._rays[:count].reshape(-1), self._groups, 1, self._body,
            self._geoms[:count], distances, None, count, self.device.max_range_m,
        )  # fmt: skip
        unseen = (distances < self.device.min_range_m) | (distances > self.device.max_range_m)
        if self._noise is not None:
            distances += self.device.noise_m * self._noise.row(tick)[chosen]
            np.maximum(distances, 0.0, out=distances)
        self.cells[chosen] = np.where(unseen, np.inf, distances)

    def _aim(self, pose: RobotPose, forward: NDArray[np.float64], left: NDArray[np.float64], count: int) -> None:
        rays = self._rays[:count]
        if pose.tipped:
            rotation = np.reshape(pose.rotation, (3, 3))
            self._origin[:] = (pose.x, pose.y, pose.z) + self._above_centre_m * rotation[:, 2]
            rays[:] = np.outer(forward, rotation[:, 0]) + np.outer(left, rotation[:, 1])
            return
        self._origin[:] = (pose.x, pose.y, pose.z + self._above_centre_m)
        rays[:, 0] = pose.cos * forward - pose.sin * left
        rays[:, 1] = pose.sin * forward + pose.cos * left
        rays[:, 2] = 0.0
