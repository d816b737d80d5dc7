"""What robots have at their front to act on balls, and which balls are there."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple

from rcj_challenges.chassis.base import YAW, is_at_front
from rcj_challenges.devices.base import Device
from rcj_challenges.scenario.kits import chassis_of, devices_of
from rcj_challenges.world.effects.base import Effect, Scene
from rcj_challenges.world.tables import one_by_one

Key = tuple[int, str]
"""Index of the robot, and the name of the device."""

LIFTED_M = 0.005
"""A ball whose centre is higher than this over its radius flies past."""


@dataclass
class Tool:
    """One tool of one robot.

    Attributes:
        device: its entry in the scenario.
        at: where its robot's x stands in `qpos` and `qvel`.
        body: of its robot.
        front_m: how far ahead of the robot's centre its body ends.
        mass_kg: of its robot.
        stopped: whether its robot is held, or has been taken off the field.
        velocity, position: as commanded.
    """

    device: Any
    at: int
    body: int
    front_m: float
    mass_kg: float
    stopped: bool = False
    velocity: float = 0.0
    position: float = 0.0


class BallAhead(NamedTuple):
    """A ball at the front of a robot.

    Attributes:
        at: where its speeds begin in `qvel`.
        turned_at: where its quaternion begins in `qpos`.
        body: of the ball.
        radius_m, mass_kg: its size.
        aside_m: how far left of the robot's middle it is.
    """

    at: int
    turned_at: int
    body: int
    radius_m: float
    mass_kg: float
    aside_m: float


class Tools(Effect):
    """All tools of one kind (`KIND`, the device), by what they are commanded."""

    KIND: ClassVar[type[Device]] = Device

    def __init__(self, scene: Scene) -> None:
        """Find the tools and the balls."""
        model, data, tables, scenario = scene.model, scene.data, scene.tables, scene.scenario
        self.qpos, self.qvel = one_by_one(data.qpos), one_by_one(data.qvel)
        self.tools: dict[Key, Tool] = {}
        for robot, name in enumerate(scene.roster.entities[: tables.robots]):
            body, front_m = tables.bodies[robot], chassis_of(scenario, name).front_m
            mass_kg = float(model.body_subtreemass[body])
            for device_name, device in devices_of(scenario, name).items():
                if isinstance(device, self.KIND):
                    self.tools[robot, device_name] = Tool(device, tables.qpos_at[robot], body, front_m, mass_kg)
        self._balls = [
            (tables.qpos_at[entity], int(tables.dofs[entity][0]), tables.bodies[entity], ball.radius_m, ball.mass_kg)
            for entity, ball in zip(tables.ball_range, scenario.balls.values(), strict=True)
        ]
        self.is_needed = bool(self.tools)

    def command(self, key: Key, velocity: float, position: float) -> None:
        """Command one."""
        self.tools[key].velocity, self.tools[key].position = velocity, position

    def set_stopped(self, robot: int, *, stopped: bool) -> None:
        """Stop the tools of a robot that is held or taken off the field, or release them."""
        for (owner, _), tool in self.tools.items():
            if owner == robot:
                tool.stopped = stopped

    def reset(self) -> None:
        for key in self.tools:
            self.command(key, 0.0, 0.0)

    def balls_ahead(self, tool: Tool, within_m: float) -> Iterator[BallAhead]:
        """Yield the balls that are so near to the front of a robot."""
        qpos = self.qpos
        x, y, yaw = qpos[tool.at], qpos[tool.at + 1], qpos[tool.at + YAW]
        c, s = math.cos(yaw), math.sin(yaw)
        for ball_at, at, body, radius_m, mass_kg in self._balls:
            dx, dy = qpos[ball_at] - x, qpos[ball_at + 1] - y
            aside_m = c * dy - s * dx
            low = qpos[ball_at + 2] < radius_m + LIFTED_M
            if low and is_at_front(tool.front_m, c * dx + s * dy, aside_m, radius_m, within_m):
                yield BallAhead(at, ball_at + 3, body, radius_m, mass_kg, aside_m)
