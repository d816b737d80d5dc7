"""Dribblers: a roller that gives the ball ahead back spin, which the floor's friction turns into a pull."""

from __future__ import annotations

import math
from typing import ClassVar

from rcj_challenges.chassis.base import YAW
from rcj_challenges.core.timing import SUBSTEP_S
from rcj_challenges.devices.dribbler import ROLLER_M, DribblerDevice
from rcj_challenges.world.effects.base import Scene
from rcj_challenges.world.effects.tools import BallAhead, Tool, Tools
from rcj_challenges.world.tables import one_by_one

REACH_M = 0.003
"""How far ahead of the body the soft roller still touches a ball."""

_CENTRED_FROM_M = 0.005
"""So far from the middle the waist of the roller pushes with all its force; nearer with less, in proportion."""

_WAIST = 0.5
"""Force with which the waist pushes, as a share of the roller's."""

_INERTIA = 2 / 5
"""Of a solid ball, as a share of mass times squared radius."""


class Dribblers(Tools):
    """All dribblers.

    Only back spin, as the rules of real leagues allow: no force holds the ball. The torque acts about the robot's left
    axis, up to the speed of the roller's rim.
    """

    KIND: ClassVar = DribblerDevice

    def __init__(self, scene: Scene) -> None:
        super().__init__(scene)
        self._applied = one_by_one(scene.data.xfrc_applied.reshape(-1))
        self._acting: list[int] = []

    def before_substep(self, _substep: int) -> None:
        for first in self._acting:
            for at in range(first, first + 6):
                self._applied[at] = 0.0
        self._acting.clear()
        for tool in self.tools.values():
            if tool.velocity and tool.position == math.inf and not tool.stopped:
                for ball in self.balls_ahead(tool, REACH_M):
                    self._turn(tool, ball)

    def _turn(self, tool: Tool, ball: BallAhead) -> None:
        yaw = self.qpos[tool.at + YAW]
        left_x, left_y = -math.sin(yaw), math.cos(yaw)
        spins_radps = self._spin(ball, left_x, left_y)
        wanted_radps = -tool.velocity * ROLLER_M / ball.radius_m
        most_nm = tool.device.force_n * ball.radius_m
        needed_nm = _INERTIA * ball.mass_kg * ball.radius_m**2 * (wanted_radps - spins_radps) / SUBSTEP_S
        torque_nm = max(-most_nm, min(most_nm, needed_nm))
        share = max(-1.0, min(1.0, ball.aside_m / _CENTRED_FROM_M))
        self._push(ball.body, -share, left_x, left_y, tool.device.force_n * _WAIST, torque_nm)
        self._push(tool.body, share, left_x, left_y, tool.device.force_n * _WAIST, 0.0)

    def _spin(self, ball: BallAhead, left_x: float, left_y: float) -> float:
        """Return the speed at which a ball turns about an axis; MuJoCo has its turning in the frame of the ball."""
        w, i, j, k = (self.qpos[ball.turned_at + part] for part in range(4))
        a, b, c = (self.qvel[ball.at + 3 + axis] for axis in range(3))
        p, q, r = 2 * (j * c - k * b), 2 * (k * a - i * c), 2 * (i * b - j * a)
        x, y = a + w * p + j * r - k * q, b + w * q + k * p - i * r
        return left_x * x + left_y * y

    def _push(self, body: int, share: float, left_x: float, left_y: float, force_n: float, torque_nm: float) -> None:
        first = 6 * body
        force_n *= share
        self._applied[first] += force_n * left_x
        self._applied[first + 1] += force_n * left_y
        self._applied[first + 3] += torque_nm * left_x
        self._applied[first + 4] += torque_nm * left_y
        self._acting.append(first)
