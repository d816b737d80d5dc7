"""Where robots and balls are, in the frames in which devices measure.

The frame of a robot that stands is level: it turns with the robot about the vertical and nothing else, and heights
are nominal. Programs divide by the small z part of the ball's direction, so a hundredth of a radian of rocking would
turn 0.58 m into 0.90 (reference, section 2). Once it has tipped over, its frame is that of its body (ADR 5); the
robots of the present world cannot (ADR 2), and then nothing of this costs anything.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import pairwise

import mujoco
import numpy as np
from numpy.typing import NDArray

from rcj_challenges.devices.ground import Ground
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster

TIPPED_FROM_RAD = math.pi / 6
"""From this tilt on a robot counts as tipped over: from there the third part of its compass can reach 0.5, which is
what programs take for "I am lying on my side" (reference, 4.1)."""

NOMINAL_WITHIN_M = 0.005
"""A centre this close to its nominal height is taken to be there: more than contacts give way or a ball hops, less
than anything that is lifted or climbs."""

BALL_SINKS_M = 0.0001
"""How much lower than its radius a resting ball's centre is. Source: reference, section 2 (0.0209 for r 0.021)."""

_COS_TIPPED = math.cos(TIPPED_FROM_RAD)
_ON_ITS_NOSE = 1e-6
_FORWARD = slice(0, 4, 3)

Vector = tuple[float, float, float]


class RobotPose:
    """Pose of one robot's cube; refreshed every tick.

    Attributes:
        x, y, z: centre of the cube in m; z is nominal while the robot stands.
        cos, sin: of the yaw.
        tipped: whether the robot lies; then ``rotation`` counts instead of the yaw.
        rotation: body to world, row by row.
        parked: whether it has been taken off the field.
    """

    __slots__ = ("_highest", "_lowest", "_nominal_z", "cos", "parked", "rotation", "sin", "tipped", "x", "y", "z")

    def __init__(self, nominal_z: float) -> None:
        """Build the pose of a robot whose centre is at the height ``nominal_z`` in m while it stands."""
        self._nominal_z = nominal_z
        self._lowest, self._highest = nominal_z - NOMINAL_WITHIN_M, nominal_z + NOMINAL_WITHIN_M
        self.x = self.y = 0.0
        self.z = nominal_z
        self.cos, self.sin = 1.0, 0.0
        self.tipped = False
        self.rotation: list[float] = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]
        self.parked = False

    def read_upright(self, position: list[float], forward: list[float]) -> None:
        """Take over the pose of a body that cannot tip: [x, y, z] in m, and [cos, sin] of the yaw."""
        self.x, self.y, _ = position
        self.cos, self.sin = forward

    def read(self, position: list[float], rotation: list[float]) -> None:
        """Take over a pose: [x, y, z] in m, and the body's rotation matrix row by row."""
        self.x, self.y, z = position
        self.rotation = rotation
        # Forward is the body's x axis, laid flat. A robot on its nose has none; it keeps its last yaw.
        forward_x, forward_y = rotation[0], rotation[3]
        length = math.sqrt(forward_x * forward_x + forward_y * forward_y)
        if length > _ON_ITS_NOSE:
            self.cos, self.sin = forward_x / length, forward_y / length
        self.tipped = tipped = rotation[8] <= _COS_TIPPED
        self.z = self._nominal_z if not tipped and self._lowest < z < self._highest else z

    @property
    def yaw(self) -> float:
        """Yaw in rad, in [-π, π]."""
        return math.atan2(self.sin, self.cos)

    def to_frame(self, dx: float, dy: float, dz: float) -> Vector:
        """Turn a vector of the world into the robot's frame: x forward, y left, z up."""
        if self.tipped:
            r = self.rotation
            return (
                r[0] * dx + r[3] * dy + r[6] * dz,
                r[1] * dx + r[4] * dy + r[7] * dz,
                r[2] * dx + r[5] * dy + r[8] * dz,
            )
        return (self.cos * dx + self.sin * dy, self.cos * dy - self.sin * dx, dz)

    def north(self) -> Vector:
        """Return the world's +y axis in the robot's frame: what a compass shows."""
        if self.tipped:
            return (self.rotation[3], self.rotation[4], self.rotation[5])
        return (self.sin, self.cos, 0.0)


class Poses:
    """Poses of all robots and balls at the current tick.

    Attributes:
        robots: by index of the robot.
        balls: centres in m, by index of the ball; z is nominal while it rolls.
        parked: by entity, whether it has been taken off the field.
        any_parked: whether there is one.
    """

    def __init__(self, scenario: Scenario, roster: Roster, ground: Ground) -> None:
        """Look up the bodies, once.

        Args:
            scenario: for nominal heights.
            roster: order of robots and balls.
            ground: the compiled world.
        """
        robots = roster.entities[: roster.robots]
        balls = roster.entities[roster.robots : roster.robots + roster.balls]
        self._ground = ground
        self._robot_positions = _rows(ground.data.xpos, [int(ground.model.body(name).id) for name in robots])
        self._robot_rotations = _rows(ground.data.xmat, [int(ground.model.body(name).id) for name in robots])
        self._can_tip = any(_can_tip(ground.model, name) for name in robots)
        self._ball_positions = _rows(ground.data.xpos, [int(ground.model.body(name).id) for name in balls])
        self._nominal_balls = [scenario.balls[name].radius_m - BALL_SINKS_M for name in balls]
        self.robots = [RobotPose(scenario.kits[scenario.robots[name].kit].chassis.size_m / 2) for name in robots]
        self.balls: list[Vector] = [(0.0, 0.0, nominal) for nominal in self._nominal_balls]
        self.parked: tuple[bool, ...] = (False,) * len(roster.entities)
        self.any_parked = False

    def refresh(self) -> None:
        """Read all poses; the world has brought them up to date."""
        positions, rotations = self._robot_positions().tolist(), self._robot_rotations()
        if self._can_tip:
            for pose, position, rotation in zip(self.robots, positions, rotations.tolist(), strict=True):
                pose.read(position, rotation)
        else:
            for pose, position, forward in zip(self.robots, positions, rotations[:, _FORWARD].tolist(), strict=True):
                pose.read_upright(position, forward)
        self.balls = [
            (x, y, nominal if abs(z - nominal) < NOMINAL_WITHIN_M else z)
            for (x, y, z), nominal in zip(self._ball_positions().tolist(), self._nominal_balls, strict=True)
        ]
        parked = tuple(self._ground.parked)
        if parked != self.parked:
            self.parked = parked
            self.any_parked = any(parked)
            for pose, gone in zip(self.robots, parked, strict=False):
                pose.parked = gone

    def ball_is_parked(self, ball: int) -> bool:
        """Return whether a ball has been taken off the field."""
        return self.parked[len(self.robots) + ball]


def _rows(array: NDArray[np.float64], rows: list[int]) -> Callable[[], NDArray[np.float64]]:
    """Return a function that gives some rows of an array: a view where they are evenly spaced, for that is faster."""
    steps = {b - a for a, b in pairwise(rows)}
    if len(rows) > 1 and len(steps) == 1 and min(steps) > 0:
        view = array[rows[0] : rows[-1] + 1 : steps.pop()]
        return lambda: view
    chosen = np.array(rows, dtype=np.intp)
    return lambda: array[chosen]


def _can_tip(model: mujoco.MjModel, body: str) -> bool:
    """Return whether a body can turn about anything but the vertical. The bodies of ADR 2 cannot."""
    first, count = int(model.body(body).jntadr[0]), int(model.body(body).jntnum[0])
    for joint in range(first, first + count):
        kind = int(model.jnt_type[joint])
        about_vertical = kind == int(mujoco.mjtJoint.mjJNT_HINGE) and abs(float(model.jnt_axis[joint, 2])) == 1.0
        if kind != int(mujoco.mjtJoint.mjJNT_SLIDE) and not about_vertical:
            return True
    return False
