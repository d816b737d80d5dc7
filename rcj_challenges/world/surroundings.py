"""Which robots are near enough to a wall or a fixed obstacle to meet it before the next tick.

MuJoCo first compares bounding spheres, and that of a side wall covers the whole field: it would look closely at every
wheel and that wall in every sub-step, an eighth of `mj_step` (ADR 10). A robot that is too far away does not collide
with fixtures at all; this changes no bit of the result.
"""

from __future__ import annotations

from typing import Any

import mujoco
import numpy as np

from rcj_challenges.facts.timing import TICK_S
from rcj_challenges.world import contact
from rcj_challenges.world.tables import Numbers, WorldTables, one_by_one

FAST_MPS = 1.0
"""Five times what a robot can drive. One that is faster has been hit by something, and counts as near."""

_MARGIN_M = 1.25 * FAST_MPS * TICK_S
_CELL_M = 0.02
_MOST_CELLS = 200
"""Along each side; a larger field has larger cells."""

_FAR, _NEAR = contact.AMONG_SOLIDS, contact.AMONG_SOLIDS | contact.FIXED


class Surroundings:
    """A map of the floor, in cells: from where a robot can meet a fixture within a tick."""

    def __init__(self, model: Any, data: Any, tables: WorldTables) -> None:
        """Draw the map.

        Args:
            model: compiled; its robots collide with fixtures.
            data: with up-to-date poses of geoms (`mj_kinematics`).
            tables: of this model.
        """
        self._qpos, self._qvel = one_by_one(data.qpos), one_by_one(data.qvel)
        self._bits = memoryview(model.geom_conaffinity)
        self._robots = [
            (tables.qpos_at[robot], (cube, *tables.wheels[robot])) for robot, cube in enumerate(tables.cubes)
        ]
        self._near = [True] * len(self._robots)
        reach_m = max((_reach_m(model, data, geoms) for _, geoms in self._robots), default=0.0)
        fixtures = [
            geom
            for geom in range(model.ngeom)
            if model.geom_bodyid[geom] == 0 and model.geom_contype[geom] & contact.FIXED
        ]
        self._draw(model, fixtures, reach_m + _MARGIN_M)

    def before_tick(self) -> None:
        """Let the robots that are near enough collide with fixtures, and no others."""
        qpos, qvel, near = self._qpos, self._qvel, self._near
        cells, rows, per_m, left_m, bottom_m = self._cells, self._rows, self._per_m, self._left_m, self._bottom_m
        most = len(cells)
        for robot, (at, geoms) in enumerate(self._robots):
            column, row = (qpos[at] - left_m) * per_m, (qpos[at + 1] - bottom_m) * per_m
            # What is beyond the map, or no number, counts as near: MuJoCo then finds out by itself.
            cell = int(column) * rows + int(row) if 0.0 <= row < rows and 0.0 <= column < most else most
            slow = -FAST_MPS < qvel[at] < FAST_MPS and -FAST_MPS < qvel[at + 1] < FAST_MPS
            now = not slow or cell >= most or cells[cell] != 0
            if now is not near[robot]:
                near[robot] = now
                for geom in geoms:
                    self._bits[geom] = _NEAR if now else _FAR

    def _draw(self, model: Any, fixtures: list[int], near_m: float) -> None:
        bounds = np.array([_bounds(model, geom) for geom in fixtures] or [(0.0, 0.0, 0.0, 0.0)])
        (left, bottom), (right, top) = bounds[:, :2].min(axis=0).tolist(), bounds[:, 2:].max(axis=0).tolist()
        cell_m = max(_CELL_M, (right - left) / _MOST_CELLS, (top - bottom) / _MOST_CELLS)
        columns, self._rows = int((right - left) / cell_m) + 1, int((top - bottom) / cell_m) + 1
        self._per_m, self._left_m, self._bottom_m = 1 / cell_m, left, bottom
        x, y = np.meshgrid(
            left + (np.arange(columns) + 0.5) * cell_m, bottom + (np.arange(self._rows) + 0.5) * cell_m, indexing="ij"
        )
        near = np.zeros(x.shape, dtype=bool)
        for geom in fixtures:
            near |= _distances(model, geom, x, y) < near_m + cell_m * np.sqrt(0.5)
        self._cells = near.astype(np.uint8).tobytes()


def _reach_m(model: Any, data: Any, geoms: tuple[int, ...]) -> float:
    """Return how far a robot's outline is at most from the centre of its cube."""
    centre = data.geom_xpos[geoms[0]]
    return float(max(np.linalg.norm(data.geom_xpos[geom] - centre) + model.geom_rbound[geom] for geom in geoms))


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
