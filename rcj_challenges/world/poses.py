"""The poses of all robots and balls at the current tick, as devices measure them."""

from __future__ import annotations

import math
from collections.abc import Sequence

from rcj_challenges.chassis.base import YAW
from rcj_challenges.devices.poses import NOMINAL_WITHIN_M, RobotPose, Vector
from rcj_challenges.scenario.kits import chassis_of
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world.tables import turned_at
from rcj_challenges.world.world import World

BALL_SINKS_M = 0.0001
"""How much lower than its radius the centre of a resting ball is. Source: reference, section 2 (0.0209 for r 0.021)."""


class Poses:
    """Poses of all robots and balls at the current tick.

    Attributes:
        balls: centres in m, by index of the ball; z is nominal while it rolls.
        state: MuJoCo's `qpos` of this tick, then the angles of wheels without joints.
        parked: by entity, whether it has been taken off the field.
    """

    def __init__(self, scenario: Scenario, roster: Roster, world: World) -> None:
        tables = world.tables
        self._qpos, self._qvel, self._turned = world.data.qpos, world.data.qvel, world.data.userdata
        self._has_turned = len(self._turned) > 0
        self._chassis = [chassis_of(scenario, name) for name in roster.entities[: roster.robots]]
        self._turned_at = turned_at(self._chassis)
        self.robots = [RobotPose(chassis.height_m / 2) for chassis in self._chassis]
        self._robots_at = tables.qpos_at[: roster.robots]
        self._speeds_at = [int(dofs[0]) for dofs in tables.dofs[: roster.robots]]
        self.radii_m = [scenario.balls[roster.entities[ball]].radius_m for ball in tables.ball_range]
        self._balls = [
            (tables.qpos_at[ball], radius_m - BALL_SINKS_M)
            for ball, radius_m in zip(tables.ball_range, self.radii_m, strict=True)
        ]
        self.balls: list[Vector] = [(0.0, 0.0, nominal) for _, nominal in self._balls]
        self.state: list[float] = []
        self.parked: Sequence[bool] = world.parked
        self.touched_at = world.touched_at

    def wheel_angle_at(self, robot: int, wheel: int) -> int:
        """Return the place of a wheel's angle in `state`; it grows while the wheel drives forward."""
        if self._chassis[robot].MOTOR_JOINT:
            return len(self._qpos) + self._turned_at[robot] + wheel
        return self._robots_at[robot] + YAW + 1 + wheel

    def velocity(self, robot: int) -> Vector:
        """Return the speed of a robot along x and y of the field, in m/s, and about z, in rad/s."""
        first = self._speeds_at[robot]
        x, y, about_z = self._qvel[first : first + 3].tolist()
        return x, y, about_z

    def refresh(self) -> None:
        """Read all poses; the world has brought them up to date."""
        self.state = state = self._qpos.tolist()
        if self._has_turned:
            state += self._turned.tolist()
        for pose, at in zip(self.robots, self._robots_at, strict=True):
            pose.x, pose.y, yaw = state[at : at + 3]
            pose.cos, pose.sin = math.cos(yaw), math.sin(yaw)
        for ball, (at, nominal) in enumerate(self._balls):
            x, y, z = state[at : at + 3]
            self.balls[ball] = (x, y, nominal if abs(z - nominal) < NOMINAL_WITHIN_M else z)
