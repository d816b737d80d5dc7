"""Balls that slow down while they roll. In the original they do not, and then nothing of this costs anything.

MuJoCo's own friction of rolling is a soft contact: a ball at 0.3 m/s that should stop within 1.5 s still rolls at 0.07
after 2.5 s. So the force is laid on the ball, anew for each tick.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from rcj_challenges.facts.timing import TICK_S
from rcj_challenges.scenario.models.field import Ball
from rcj_challenges.world.tables import WorldTables, one_by_one

_TURNING_ALONG = 7 / 5
"""A ball that rolls resists like this many times its mass: its turning must be slowed down too."""

_AT_REST_MPS = 1e-9


class Rolling:
    """The forces that slow balls down."""

    def __init__(self, data: Any, tables: WorldTables, balls: Mapping[str, Ball]) -> None:
        """Find the balls that slow down.

        Args:
            data: MuJoCo's.
            tables: of the same model.
            balls: of the scenario, in the order of the roster.
        """
        self._qvel, self._forces_n = one_by_one(data.qvel), one_by_one(data.qfrc_applied)
        self._balls = [
            (int(tables.dofs[entity][0]), ball.mass_kg * _TURNING_ALONG, ball.slows_mps2)
            for entity, ball in zip(tables.ball_range, balls.values(), strict=True)
            if ball.slows_mps2 is not None
        ]

    def before_tick(self) -> None:
        """Lay on each ball the force that takes its speed away; one that would come to rest in this tick does."""
        for at, inertia_kg, slows_mps2 in self._balls:
            vx, vy = self._qvel[at], self._qvel[at + 1]
            speed_mps = math.hypot(vx, vy)
            if speed_mps < _AT_REST_MPS:
                self._forces_n[at] = self._forces_n[at + 1] = 0.0
                continue
            per_speed = -inertia_kg * min(slows_mps2, speed_mps / TICK_S) / speed_mps
            self._forces_n[at], self._forces_n[at + 1] = per_speed * vx, per_speed * vy
