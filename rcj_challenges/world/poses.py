"""The poses of all robots and balls at the current tick, as devices measure them."""

from __future__ import annotations

import math
from collections.abc import Sequence

import mujoco

from rcj_challenges.devices.poses import NOMINAL_WITHIN_M, RobotPose, Vector
from rcj_challenges.scenario.kits import chassis_of
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world.ground import Ground
from rcj_challenges.world.tables import turned_at

BALL_SINKS_M = 0.0001
"""How much lower than its radius the centre of a resting ball is. Source: reference, section 2 (0.0209 for r 0.021)."""


class Poses:
    """Poses of all robots and balls at the current tick.

    Attributes:
        balls: centres in m, by index of the ball; z is nominal while it rolls.
        state: MuJoCo's `qpos` of this tick, then the angles of wheels without joints.
        parked: by entity, whether it has been taken off the field.
    """

    def __init__(self, scenario: Scenario, roster: Roster, ground: Ground) -> None:
        model = ground.model
        robots = roster.entities[: roster.robots]
        balls = roster.entities[roster.robots : roster.robots + roster.balls]
        self._ground = ground
        self._qpos, self._turned = ground.data.qpos, ground.data.userdata
        self._has_turned = len(self._turned) > 0
        self._chassis = {name: chassis_of(scenario, name) for name in robots}
        self.robots = [RobotPose(chassis.height_m / 2) for chassis in self._chassis.values()]
        self._planar: list[tuple[RobotPose, int]] = []
        self._free: list[tuple[RobotPose, int]] = []
        for pose, name in zip(self.robots, robots, strict=True):
            kind = self._planar if _is_planar(model, name) else self._free
            kind.append((pose, int(model.jnt_qposadr[model.body(name).jntadr[0]])))
        self._balls = [
            (int(model.jnt_qposadr[model.body(name).jntadr[0]]), scenario.balls[name].radius_m - BALL_SINKS_M)
            for name in balls
        ]
        self.balls: list[Vector] = [(0.0, 0.0, nominal) for _, nominal in self._balls]
        self.radii_m = [scenario.balls[name].radius_m for name in balls]
        self._qvel = ground.data.qvel
        # Where the speeds along x and y and about z of each robot stand.
        self._moves = [
            (first, first + 1, first + (2 if _is_planar(model, name) else 5))
            for name in robots
            for first in (int(model.body_dofadr[model.body(name).id]),)
        ]
        self.state: list[float] = []
        self.parked: tuple[bool, ...] = (False,) * len(roster.entities)

    def wheel_angle_at(self, robot_name: str, wheel: int) -> int:
        """Return the place of a wheel's angle in `state`; it grows while the wheel drives forward."""
        chassis = self._chassis[robot_name]
        if chassis.MOTOR_JOINT:
            return len(self._qpos) + turned_at(self._chassis.values())[list(self._chassis).index(robot_name)] + wheel
        return int(self._ground.model.joint(f"{robot_name}/{chassis.wheels()[wheel].part}").qposadr[0])

    def velocity(self, robot: int) -> Vector:
        """Return the speed of a robot along x and y of the field, in m/s, and about z, in rad/s."""
        x, y, about_z = self._moves[robot]
        return float(self._qvel[x]), float(self._qvel[y]), float(self._qvel[about_z])

    def touched_at(self, robot: int) -> Sequence[float]:
        """Return the bearings at which a robot touched walls, obstacles and robots in this tick, in its frame."""
        return self._ground.touched_at(robot)

    def refresh(self) -> None:
        """Read all poses; the world has brought them up to date."""
        self.state = state = self._qpos.tolist()
        if self._has_turned:
            state += self._turned.tolist()
        for pose, at in self._planar:
            pose.x, pose.y, yaw = state[at : at + 3]
            pose.cos, pose.sin = math.cos(yaw), math.sin(yaw)
        for pose, at in self._free:
            pose.read(state[at : at + 3], state[at + 3 : at + 7])
        for ball, (at, nominal) in enumerate(self._balls):
            x, y, z = state[at : at + 3]
            self.balls[ball] = (x, y, nominal if abs(z - nominal) < NOMINAL_WITHIN_M else z)
        parked = tuple(self._ground.parked)
        if parked != self.parked:
            self.parked = parked
            for pose, gone in zip(self.robots, parked, strict=False):
                pose.parked = gone


_PLANAR_JOINTS = (
    (mujoco.mjtJoint.mjJNT_SLIDE, (1.0, 0.0, 0.0)),
    (mujoco.mjtJoint.mjJNT_SLIDE, (0.0, 1.0, 0.0)),
    (mujoco.mjtJoint.mjJNT_HINGE, (0.0, 0.0, 1.0)),
)


def _is_planar(model: mujoco.MjModel, body: str) -> bool:
    """Return whether a body slides along x and y and turns about z, as in ADR 2; otherwise it moves freely.

    Raises:
        TypeError: it does neither.
    """
    first, count = int(model.body(body).jntadr[0]), int(model.body(body).jntnum[0])
    joints = tuple(
        (mujoco.mjtJoint(int(model.jnt_type[joint])), tuple(model.jnt_axis[joint].tolist()))
        for joint in range(first, first + count)
    )
    if joints == _PLANAR_JOINTS:
        return True
    if [kind for kind, _ in joints] != [mujoco.mjtJoint.mjJNT_FREE]:
        raise TypeError(f"body {body!r} moves neither in the plane nor freely")
    return False
