"""Which robots are near enough to a wall or a fixed obstacle to meet it.

MuJoCo first compares bounding spheres, and that of a side wall covers the whole field: it would look closely at every
wheel and that wall in every sub-step, an eighth of `mj_step` (ADR 10). A robot that is too far away does not collide
with fixtures at all. MuJoCo collides what stands where `qpos` says before each sub-step, and that is when it is looked
whether the robot has left the part of the map in which that was so: this changes no bit of the result, however fast a
robot is.
"""

from __future__ import annotations

import math
from typing import Any

import mujoco
import numpy as np
from numpy.typing import NDArray

from rcj_challenges.world import contact
from rcj_challenges.world.tables import Numbers, WorldTables, one_by_one

_ROUNDING_M = 0.001
_CELL_M = 0.02
_MOST_CELLS = 200
"""Along each side; a larger field has larger cells."""
_MOST_ALIKE = 8
"""Cells in each direction that are looked at together: in the middle of the field a robot at full speed needs 0.8 s to
leave them."""

Cells = NDArray[np.uint8]
"""``[column][row]``"""
Around = tuple[float, float, float, float]
"""Lowest and highest x, lowest and highest y."""
_NOWHERE: Around = (math.inf, -math.inf, math.inf, -math.inf)

_FAR, _NEAR = contact.AMONG_SOLIDS, contact.AMONG_SOLIDS | contact.FIXED


class Surroundings:
    """A map of the floor, in cells: from where a robot can touch a fixture."""

    def __init__(self, model: Any, data: Any, tables: WorldTables) -> None:
        """Draw the map.

        Args:
            model: compiled; its robots collide with fixtures.
            data: with up-to-date poses of geoms (`mj_kinematics`).
            tables: of this model.
        """
        self._qpos = one_by_one(data.qpos)
        self._bits = memoryview(model.geom_conaffinity)
        self._geoms = [(cube, *tables.wheels[robot]) for robot, cube in enumerate(tables.cubes)]
        # By robot: its index, where its x and y stand in `qpos`, and between which of them it is as near as it was.
        self._robots = [(robot, at, at + 1, *_NOWHERE) for robot, at in enumerate(tables.qpos_at[: tables.robots])]
        farthest_m = max((reach_m(model, data, geoms) for geoms in self._geoms), default=0.0)
        fixtures = [
            geom
            for geom in range(model.ngeom)
            if model.geom_bodyid[geom] == 0 and model.geom_contype[geom] & contact.FIXED
        ]
        self._draw(model, fixtures, farthest_m + _ROUNDING_M)

    def before_substep(self) -> None:
        """Let the robots that are near enough collide with fixtures, and no others."""
        qpos = self._qpos
        for robot, x_at, y_at, x_low, x_high, y_low, y_high in self._robots:
            if not (x_low < qpos[x_at] < x_high and y_low < qpos[y_at] < y_high):
                self._look(robot, x_at, y_at)

    def _look(self, robot: int, x_at: int, y_at: int) -> None:
        """Find out whether a robot is near, and how far around it that is so."""
        near, around = self._found(self._qpos[x_at], self._qpos[y_at])
        self._robots[robot] = (robot, x_at, y_at, *around)
        for geom in self._geoms[robot]:
            self._bits[geom] = _NEAR if near else _FAR

    def _found(self, x_m: float, y_m: float) -> tuple[int, Around]:
        """Return whether fixtures are near, and around which place that is so."""
        try:
            column, row = self._cell(x_m, y_m)
        except (ValueError, OverflowError):  # no number: MuJoCo finds out by itself
            return 1, _NOWHERE
        if not (0 <= column < self._columns and 0 <= row < self._rows):  # the map goes on until all fixtures are far
            return 0, _NOWHERE
        cell = column * self._rows + row
        alike, cell_m = self._alike[cell], 1 / self._per_m
        left_m, bottom_m = self._left_m + column * cell_m, self._bottom_m + row * cell_m
        before_m, after_m = (alike - 1) * cell_m, alike * cell_m
        return self._cells[cell], (left_m - before_m, left_m + after_m, bottom_m - before_m, bottom_m + after_m)

    def _draw(self, model: Any, fixtures: list[int], near_m: float) -> None:
        bounds = np.array([_bounds(model, geom) for geom in fixtures] or [(0.0, 0.0, 0.0, 0.0)])
        (left, bottom), (right, top) = bounds[:, :2].min(axis=0).tolist(), bounds[:, 2:].max(axis=0).tolist()
        cell_m = max(_CELL_M, (right - left) / _MOST_CELLS, (top - bottom) / _MOST_CELLS)
        near_m += cell_m * math.sqrt(0.5)
        # A cell more on each side: numbers just below 0 are rounded up to it.
        self._left_m, self._bottom_m = left - near_m - cell_m, bottom - near_m - cell_m
        self._per_m = 1 / cell_m
        self._columns = int((right + near_m - self._left_m) * self._per_m) + 2
        self._rows = int((top + near_m - self._bottom_m) * self._per_m) + 2
        near = np.zeros((self._columns, self._rows), dtype=np.uint8)
        for geom, (x_0, y_0, x_1, y_1) in zip(fixtures, bounds.tolist(), strict=True):
            first_x, first_y = self._cell(x_0 - near_m, y_0 - near_m)
            last_x, last_y = self._cell(x_1 + near_m, y_1 + near_m)
            x = self._left_m + (np.arange(first_x, last_x + 1) + 0.5) * cell_m
            y = self._bottom_m + (np.arange(first_y, last_y + 1) + 0.5) * cell_m
            close = _distances(model, geom, x[:, None], y[None, :]) < near_m
            near[first_x : last_x + 1, first_y : last_y + 1] |= close
        self._cells, self._alike = near.tobytes(), _alike(near).tobytes()

    def _cell(self, x_m: float, y_m: float) -> tuple[int, int]:
        return int((x_m - self._left_m) * self._per_m), int((y_m - self._bottom_m) * self._per_m)


def reach_m(model: Any, data: Any, geoms: tuple[int, ...]) -> float:
    """Return how far a robot's outline is at most from the centre of its cube."""
    centre = data.geom_xpos[geoms[0]]
    return float(max(np.linalg.norm(data.geom_xpos[geom] - centre) + model.geom_rbound[geom] for geom in geoms))


def _alike(near: Cells) -> Cells:
    """Return how many cells in each direction, itself included, are as near as each one is: 1 to `_MOST_ALIKE`."""
    alike = np.zeros_like(near)
    for value in (0, 1):
        same = (near == value).astype(np.uint8)
        for _ in range(_MOST_ALIKE):
            alike += same
            same = _without_edge(same)
    return alike


def _without_edge(same: Cells) -> Cells:
    """Return those whose eight neighbours are among them; at the edge of the map some are missing."""
    wide = np.pad(same, ((1, 1), (0, 0)))
    same = wide[:-2] & same & wide[2:]
    wide = np.pad(same, ((0, 0), (1, 1)))
    return wide[:, :-2] & same & wide[:, 2:]


def _footprint(model: Any, geom: int) -> tuple[Numbers, float, float, float]:
    """Return the centre, half sizes and yaw of the box, or of that around the cylinder, that a fixture covers."""
    w, _, _, z = model.geom_quat[geom].tolist()
    half_x, second, _ = model.geom_size[geom].tolist()
    half_y = half_x if model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_CYLINDER else second
    return model.geom_pos[geom], half_x, half_y, 2 * float(np.arctan2(z, w))


def _bounds(model: Any, geom: int) -> tuple[float, float, float, float]:
    """Return the smallest and largest x and y of a fixture: x, y, x, y."""
    (x, y, _), half_x, half_y, yaw = _footprint(model, geom)
    cos, sin = abs(float(np.cos(yaw))), abs(float(np.sin(yaw)))
    reach_x, reach_y = cos * half_x + sin * half_y, sin * half_x + cos * half_y
    return float(x - reach_x), float(y - reach_y), float(x + reach_x), float(y + reach_y)


def _distances(model: Any, geom: int, x: Numbers, y: Numbers) -> Numbers:
    """Return how far points are at least from a fixture, in m."""
    centre, half_x, half_y, yaw = _footprint(model, geom)
    dx, dy = x - centre[0], y - centre[1]
    cos, sin = np.cos(yaw), np.sin(yaw)
    beside_x = np.maximum(np.abs(cos * dx + sin * dy) - half_x, 0.0)
    beside_y = np.maximum(np.abs(cos * dy - sin * dx) - half_y, 0.0)
    distances: Numbers = np.hypot(beside_x, beside_y)
    return distances
