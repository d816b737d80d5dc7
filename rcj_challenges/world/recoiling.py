"""Movable obstacles that a ball glances off: how they answer if its push was another than MuJoCo's.

An obstacle glides and turns in the plane, and each of its three degrees of freedom has dry friction of its own
(`gliding`). So what it does under the push of one ball, and of nothing else, can be said exactly.
"""

from __future__ import annotations

import math
from typing import Any

from rcj_challenges.facts.timing import SUBSTEP_S
from rcj_challenges.world.tables import ROBOT_YAW, WorldTables, one_by_one

Vector = tuple[float, float, float]

_HELD = 1e-3
"""What friction holds still moves a little, as it is not quite rigid: by less than this share of what it could stop."""


class Recoiling:
    """One movable obstacle, in a sub-step in which a single ball touches it."""

    def __init__(self, model: Any, data: Any, tables: WorldTables, entity: int) -> None:
        """Find the obstacle.

        Args:
            model: compiled.
            data: MuJoCo's.
            tables: of the same model.
            entity: its index.
        """
        self._qpos, self._qvel = one_by_one(data.qpos), one_by_one(data.qvel)
        self._qacc, self._limits_n = one_by_one(data.qacc), one_by_one(model.dof_frictionloss)
        self._at, self._first = tables.qpos_at[entity], int(tables.dofs[entity][0])
        # Mass along x and y, moment of inertia about the vertical through its middle.
        self._inertias: list[float] = model.dof_M0[self._first : self._first + ROBOT_YAW + 1].tolist()

    def speed_mps(self, point: Vector, way: Vector) -> float:
        """Return how fast the obstacle's surface moves in a direction, at a point of the field."""
        return sum(self._qvel[self._first + k] * arm for k, arm in enumerate(self._arms(point, way)))

    def yields_per_kg(self, point: Vector, way: Vector) -> float:
        """Return by how much its surface gives way to an impulse, in m/s for each N·s; not where friction holds it."""
        given = 0.0
        for k, arm in enumerate(self._arms(point, way)):
            inertia = self._inertias[k]
            if abs(self._qvel[self._first + k]) > _HELD * self._limits_n[self._first + k] * SUBSTEP_S / inertia:
                given += arm * arm / inertia
        return given

    def take(self, point: Vector, impulse_ns: Vector) -> None:
        """Let the ball's impulse in this sub-step have been this one, and friction hold against it."""
        for k, turned in enumerate(self._arms(point, impulse_ns)):
            at = self._first + k
            before = self._qvel[at] - self._qacc[at] * SUBSTEP_S
            pushed = before + turned / self._inertias[k]
            stopped = self._limits_n[at] * SUBSTEP_S / self._inertias[k]
            self._qvel[at] = math.copysign(max(0.0, abs(pushed) - stopped), pushed)

    def _arms(self, point: Vector, way: Vector) -> Vector:
        """Return what a vector at a point does along x, along y and about the vertical."""
        x, y = point[0] - self._qpos[self._at], point[1] - self._qpos[self._at + 1]
        return way[0], way[1], x * way[1] - y * way[0]
