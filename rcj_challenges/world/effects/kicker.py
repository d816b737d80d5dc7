"""Kickers: an impulse on the ball ahead, and the opposite one on the robot."""

from __future__ import annotations

import math
from typing import ClassVar

from rcj_challenges.chassis.base import YAW
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.devices.kicker import KickerDevice
from rcj_challenges.world.effects.base import Scene
from rcj_challenges.world.effects.tools import Key, Tools

REACH_M = 0.006
"""How far the plunger of a kicker hits. Source: the zone of grSim's robots, with the size of these."""


class Kickers(Tools):
    """All kickers.

    A kick gives the ball a speed along the robot's heading relative to the robot, and nothing across and no spin, so
    that the ball slides first. The energy comes from a capacitor: the share of the charge is the share of the speed.
    It is empty afterwards, whether there was a ball or not.
    """

    KIND: ClassVar = KickerDevice

    def __init__(self, scene: Scene) -> None:
        super().__init__(scene)
        self._charges: dict[Key, float] = {}
        self._fired_mps: dict[Key, float] = {}

    def reset(self) -> None:
        super().reset()
        self._charges = dict.fromkeys(self.tools, 1.0)
        self._fired_mps.clear()

    def command(self, key: Key, velocity: float, position: float) -> None:
        """Fire when the plunger is sent out; it must have been back before."""
        tool = self.tools[key]
        if position > 0.0 >= tool.position and velocity and not tool.stopped:
            self._fired_mps[key] = abs(velocity)
        super().command(key, velocity, position)

    def before_substep(self, substep: int) -> None:
        if substep:
            return
        for key, speed_mps in self._fired_mps.items():
            self._kick(key, speed_mps * self._charges[key])
            self._charges[key] = 0.0
        self._fired_mps.clear()
        for key, charge in self._charges.items():
            if charge < 1.0:
                self._charges[key] = min(1.0, charge + TICK_S / self.tools[key].device.recharge_s)

    def _kick(self, key: Key, speed_mps: float) -> None:
        tool, qvel = self.tools[key], self.qvel
        yaw = self.qpos[tool.at + YAW]
        c, s = math.cos(yaw), math.sin(yaw)
        for ball in self.balls_ahead(tool, REACH_M):
            impulse_ns = speed_mps / (1 / ball.mass_kg + 1 / tool.mass_kg)
            for at, change_mps in ((ball.at, impulse_ns / ball.mass_kg), (tool.at, -impulse_ns / tool.mass_kg)):
                qvel[at] += change_mps * c
                qvel[at + 1] += change_mps * s
