"""Stops small, fast balls at the near side of a thing that they would pass, or sink into, within one sub-step.

MuJoCo looks for contacts where things are before each sub-step, and pushes what is inside a thing out on the nearest
side. A marble of 5 mm at 2 m/s moves 16 mm in a sub-step: one in two was through a wall of 5 mm, and of those that met
a thick wall or a robot some were pushed down into the floor and stuck there (ADR 2).
"""

from __future__ import annotations

import math
from typing import Any

import mujoco
import numpy as np

from rcj_challenges.core.timing import SUBSTEP_S
from rcj_challenges.scenario.models.field import Box, Obstacle, Wall
from rcj_challenges.world import contact
from rcj_challenges.world.effects.base import Effect, Scene
from rcj_challenges.world.tables import one_by_one

_FASTEST_MPS = 4.0
"""Up to here field walls are tested (ADR 2); kicks go up to 3 m/s."""

_TOUCHES = 0.05
"""A stopped ball overlaps the thing by this share of its radius: then MuJoCo finds the contact and lets it bounce."""

_SOLIDS = (contact.GROUP_FIXTURES, contact.GROUP_CHASSIS, contact.GROUP_WHEELS, contact.GROUP_BORDER)


class Tunneling(Effect):
    """Balls that can sink too deep into something, within a sub-step, to be pushed out on the near side."""

    def __init__(self, scene: Scene) -> None:
        model, data, tables = scene.model, scene.data, scene.tables
        balls, obstacles = scene.scenario.balls, scene.scenario.obstacles.values()
        self._model, self._data = model, data
        self._qpos, self._qvel = one_by_one(data.qpos), one_by_one(data.qvel)
        thinnest_m = min(map(_thickness_m, obstacles), default=math.inf)
        # By ball: its body, where it stands in `qpos` and `qvel`, its radius, how far it moves at most without looking:
        # its centre is then nearer to the side that it met than to the far side, and to the floor.
        self._balls = [
            (tables.bodies[entity], tables.qpos_at[entity], int(tables.dofs[entity][0]), ball.radius_m, stops_m)
            for entity, ball in zip(tables.ball_range, balls.values(), strict=True)
            if (stops_m := ball.radius_m + min(ball.radius_m, thinnest_m / 2)) < _FASTEST_MPS * SUBSTEP_S
        ]
        self._solids = np.array([group in _SOLIDS for group in range(6)], dtype=np.uint8)
        self._geom, self._normal = np.zeros(1, dtype=np.int32), np.zeros(3)
        self.is_needed = bool(self._balls)

    def after_substep(self, _pattern: bytes) -> None:
        qvel = self._qvel
        for body, at, first, radius_m, stops_m in self._balls:
            x, y, z = (qvel[first + axis] * SUBSTEP_S for axis in range(3))
            moved_m = math.hypot(x, y, z)
            if moved_m > stops_m:
                self._look_back(body, at, radius_m, np.array((x, y, z)) / moved_m, moved_m)

    def _look_back(self, body: int, at: int, radius_m: float, way: Any, moved_m: float) -> None:
        """Cast a ray from the ball's last position along its path."""
        # Euler's integrator moves a ball by its new velocity.
        was = np.array(self._qpos[at : at + 3]) - way * moved_m
        met_m = mujoco.mj_ray(
            self._model, self._data, was, way, self._solids, True, body, self._geom, self._normal
        )  # fmt: skip
        against = -float(self._normal @ way)
        if met_m < 0.0 or met_m > moved_m or against <= 0.0:
            return
        on_m = max(0.0, met_m - (1 - _TOUCHES) * radius_m / against)
        for axis in range(3):
            self._qpos[at + axis] = float(was[axis] + way[axis] * on_m)


def _thickness_m(obstacle: Obstacle) -> float:
    if isinstance(obstacle, Box):
        return min(obstacle.size_m)
    return obstacle.thickness_m if isinstance(obstacle, Wall) else 2 * obstacle.radius_m
