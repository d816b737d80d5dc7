"""Contacts of robots with poles: near a round obstacle, MuJoCo uses one point per contact of curved sides.

By default MuJoCo looks for several points if two convex bodies touch, and then uses the flat side of a wheel even if
its rim meets a pole: the wheel sank in by 8 mm, and the robot drove past. With only one point, a braked robot that is
pushed at the flat side of its wheel creeps away. So one point is used only while a robot is so close to a pole that the
two could touch (ADR 2).
"""

from __future__ import annotations

import mujoco

from rcj_challenges.scenario.models.field import Cylinder
from rcj_challenges.world.effects.base import Effect, Scene
from rcj_challenges.world.tables import one_by_one, reach_m

_ROUNDING_M = 0.001
_ONE_POINT = int(mujoco.mjtDisableBit.mjDSBL_MULTICCD)


class CylinderContacts(Effect):
    """All round obstacles, fixed and movable."""

    def __init__(self, scene: Scene) -> None:
        model, data, tables = scene.model, scene.data, scene.tables
        obstacles, entities = scene.scenario.obstacles, scene.roster.entities
        self._options, self._qpos = model.opt, one_by_one(data.qpos)
        self._several = int(model.opt.disableflags)
        self._robots = [
            (tables.qpos_at[robot], _ROUNDING_M + reach_m(model, data, geoms))
            for robot, geoms in enumerate(tables.chassis)
        ]
        round_ones = {name: one for name, one in obstacles.items() if isinstance(one, Cylinder)}
        self._fixed = [(*one.centre_m, one.radius_m) for one in round_ones.values() if not one.movable]
        self._movable = [
            (tables.qpos_at[entities.index(name)], one.radius_m) for name, one in round_ones.items() if one.movable
        ]
        self.is_needed = bool(self._fixed or self._movable)

    def before_substep(self, _substep: int) -> None:
        self._options.disableflags = self._several | _ONE_POINT if self._any_near() else self._several

    def _any_near(self) -> bool:
        qpos = self._qpos
        poles = self._fixed + [(qpos[at], qpos[at + 1], radius_m) for at, radius_m in self._movable]
        for at, far_m in self._robots:
            x, y = qpos[at], qpos[at + 1]
            for pole_x, pole_y, radius_m in poles:
                if (pole_x - x) ** 2 + (pole_y - y) ** 2 < (far_m + radius_m) ** 2:
                    return True
        return False
