"""Wheels: what they are commanded, and how their grip follows the robot's yaw.

A motor is as in the original: so strong that only grip limits the robot. The wheel therefore turns exactly as
commanded, and dry friction between wheel and floor (the grip tendons of `build_bodies`) does the rest.
"""

from __future__ import annotations

import math
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from rcj_challenges.facts.timing import SUBSTEP_S
from rcj_challenges.scenario.models.robots import Chassis
from rcj_challenges.world import contact
from rcj_challenges.world.tables import WorldTables

Side = Literal["left", "right"]
SIDES: dict[str, int] = {"left": 0, "right": 1}

POSITION_GAIN_PS = 10.0
"""A wheel on its way to a target angle turns at gain times what is left. Source: the Webots reference, Motor: the
default of ``controlPID`` is a proportional gain of 10."""

ARRIVED_RAD = 1e-6
"""This close to its target angle a wheel is set on it and held."""

_COEFFICIENTS_PER_ROBOT = 10
"""Of its grip tendons: 4 left (x, y, yaw, wheel), 4 right, 2 across (y, x)."""


class Traction:
    """The wheels of all robots."""

    def __init__(self, model: Any, data: Any, tables: WorldTables, chassis: list[Chassis], friction: float) -> None:
        robots = tables.robots
        self._qpos, self._qvel = data.qpos, data.qvel
        self._wheel_at, self._wheel_dofs = tables.wheel_at, tables.wheel_dofs
        self._yaw_at = tables.pose_at[:robots, 2].copy()
        # The grip tendons are the model's first ones, in the order of the robots.
        self._coefficients = model.wrap_prm[: _COEFFICIENTS_PER_ROBOT * robots].reshape(robots, _COEFFICIENTS_PER_ROBOT)
        self._along_x = self._coefficients[:, 0:9:4]
        self._along_y = self._coefficients[:, 1:6:4]
        self._across_x = self._coefficients[:, 9:]
        self._slip = data.ten_velocity[: 3 * robots].reshape(robots, 3)[:, :2]
        self._grip = model.tendon_frictionloss[: 3 * robots].reshape(robots, 3)[:, :2]
        self._radii_m = np.array([one.wheel_radius_m for one in chassis]).reshape(robots, 1)
        grips = [contact.grip_of(one, friction) for one in chassis]
        self._drive_n = np.array([grip.drive_n for grip in grips]).reshape(robots, 1)
        self._brake_n = np.array([grip.brake_n for grip in grips]).reshape(robots, 1)
        # While a wheel still rolls faster than one sub-step can stop it, brakes cannot overshoot into driving.
        self._stops_mps = friction * contact.GRAVITY_MPS2 * SUBSTEP_S
        self._commanded = [[0.0, 0.0] for _ in range(robots)]
        self._targets = [[0.0, 0.0] for _ in range(robots)]
        self._speeds: NDArray[np.float64] = np.zeros((robots, 2))
        self._stopped = [False] * robots
        self._on_the_way: list[tuple[int, int]] = []
        self.brake_all()

    def brake_all(self) -> None:
        """Hold every wheel where it is: robots that nobody has commanded yet."""
        for robot in range(len(self._targets)):
            self._stopped[robot] = False
            for side in (0, 1):
                self._commanded[robot][side] = 0.0
                self._targets[robot][side] = self._angle(robot, side)
                self._update(robot, side)

    def set_wheel(self, robot: int, side: int, velocity_radps: float, position_rad: float) -> None:
        """Command a wheel: at a velocity (position ``inf``), or to an angle at this velocity at most."""
        self._commanded[robot][side] = velocity_radps
        self._targets[robot][side] = position_rad
        self._update(robot, side)

    def set_stopped(self, robot: int, *, stopped: bool) -> None:
        """Stop the wheels of a robot that is taken off the field; let them go on as commanded when it is back."""
        if self._stopped[robot] != stopped:
            self._stopped[robot] = stopped
            self._update(robot, 0)
            self._update(robot, 1)

    def angles(self) -> list[tuple[float, float]]:
        """Return (left, right) in rad by robot."""
        angles = self._qpos[self._wheel_at].tolist()
        return list(zip(angles[0::2], angles[1::2], strict=True))

    def before_substep(self) -> None:
        """Turn the wheels as commanded, and the grip with the robots."""
        yaw = self._qpos[self._yaw_at][:, None]
        sin = np.sin(yaw)
        self._along_x[:] = np.cos(yaw)
        self._along_y[:] = sin
        np.negative(sin, out=self._across_x)
        if self._on_the_way:
            self._steer_to_targets()
        self._qvel[self._wheel_dofs] = self._speeds.ravel()

    def before_tick(self) -> None:
        """Choose the grip of each wheel: whether it pushes its robot on, or slows or holds it."""
        speeds = self._speeds
        rim_mps = speeds * self._radii_m
        # Ground speed at the wheel times its commanded direction: negative while it is to be reversed.
        ahead = (self._slip + rim_mps) * np.sign(speeds)
        self._grip[:] = np.where((speeds == 0.0) | (ahead < -self._stops_mps), self._brake_n, self._drive_n)

    def _angle(self, robot: int, side: int) -> float:
        return float(self._qpos[self._wheel_at[2 * robot + side]])

    def _update(self, robot: int, side: int) -> None:
        """Take over a wheel's command."""
        key = (robot, side)
        if key in self._on_the_way:
            self._on_the_way.remove(key)
        by_velocity = math.isinf(self._targets[robot][side])
        self._speeds[robot, side] = 0.0
        if self._stopped[robot]:
            return
        if by_velocity:
            self._speeds[robot, side] = self._commanded[robot][side]
        elif self._angle(robot, side) != self._targets[robot][side]:
            self._on_the_way.append(key)

    def _steer_to_targets(self) -> None:
        for robot, side in tuple(self._on_the_way):
            left_rad = self._targets[robot][side] - self._angle(robot, side)
            if abs(left_rad) <= ARRIVED_RAD:
                self._qpos[self._wheel_at[2 * robot + side]] = self._targets[robot][side]
                self._speeds[robot, side] = 0.0
                self._on_the_way.remove((robot, side))
                continue
            limit = abs(self._commanded[robot][side])
            self._speeds[robot, side] = max(-limit, min(limit, POSITION_GAIN_PS * left_rad))
