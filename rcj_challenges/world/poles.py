"""Robots at poles: while a robot may touch a round obstacle, bodies touch at one point of their curved sides.

MuJoCo looks for several points wherever two convex bodies touch, and then takes the flat side of a wheel for what
touches, also where its rim meets a pole: the wheel sank in by 8 mm, and the robot drove past. With one point only, a
braked robot that is pushed at the flat side of its wheel creeps away. So it is one point as long as a robot stands so
near to a pole that the two could touch (ADR 2).
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import mujoco

from rcj_challenges.scenario.models.field import Cylinder, Obstacle
from rcj_challenges.world.surroundings import reach_m
from rcj_challenges.world.tables import WorldTables, one_by_one

_ROUNDING_M = 0.001
_ONE_POINT = int(mujoco.mjtDisableBit.mjDSBL_MULTICCD)


class Poles:
    """All round obstacles, fixed and movable."""

    def __init__(
        self, model: Any, data: Any, tables: WorldTables, obstacles: Mapping[str, Obstacle], entities: tuple[str, ...]
    ) -> None:
        """Find them.

        Args:
            model: compiled.
            data: with up-to-date poses of geoms (`mj_kinematics`).
            tables: of the same model.
            obstacles: of the scenario.
            entities: names, in their order.
        """
        self._options, self._qpos = model.opt, one_by_one(data.qpos)
        self._several = int(model.opt.disableflags)
        self._robots = [
            (tables.qpos_at[robot], _ROUNDING_M + reach_m(model, data, (cube, *tables.wheels[robot])))
            for robot, cube in enumerate(tables.cubes)
        ]
        round_ones = {name: one for name, one in obstacles.items() if isinstance(one, Cylinder)}
        self._fixed = [(*one.centre_m, one.radius_m) for one in round_ones.values() if not one.movable]
        self._movable = [
            (tables.qpos_at[entities.index(name)], one.radius_m) for name, one in round_ones.items() if one.movable
        ]

    def __bool__(self) -> bool:
        """Return whether there are any."""
        return bool(self._fixed or self._movable)

    def before_substep(self) -> None:
        """Say how many points of contact MuJoCo looks for, by where things stand now."""
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
