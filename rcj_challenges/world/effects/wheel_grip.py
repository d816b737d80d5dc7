"""Wheels: their commands, and how their grip follows the robot's yaw.

A motor is as in the original: so strong that only grip limits the robot. The wheel therefore turns exactly as
commanded, and dry friction between wheel and floor (the grip tendons of `build_bodies`) does the rest.
"""

from __future__ import annotations

import math
from struct import Struct

from rcj_challenges.core.timing import SUBSTEPS_PER_TICK, TICK_S
from rcj_challenges.devices.base import Side
from rcj_challenges.world import contact
from rcj_challenges.world.effects.base import Effect, Scene
from rcj_challenges.world.tables import ROBOT_YAW, one_by_one

SIDES: dict[Side, int] = {"left": 0, "right": 1}

POSITION_GAIN_PS = 10.0
"""A wheel on its way to a target angle turns at gain times what is left. Source: the Webots reference, Motor: the
default of ``controlPID`` is a proportional gain of 10."""

ARRIVED_RAD = 1e-6
"""This close to its target angle a wheel is set on it and held."""

# Robots come first in the model, and so do their grip tendons: left wheel, across, right wheel.
_TENDONS_PER_ROBOT = 3
_COEFFICIENTS_PER_ROBOT = 10
_FIRST_TURNING = 2
"""Index of the first of a robot's six coefficients that turn with it: left wheel x, y; across x, y; right wheel x,
y."""
_TURNING = Struct("6d")

_QUARTER_TURN_RAD = math.pi / 2

_FASTER_MPS = 1e-3
"""A robot that is faster than its wheel by more than this is slowed down by it."""


class Wheel:
    """One wheel and its command.

    Attributes:
        arm_m: how far left of the cube's centre it is; negative on the right.
        radius_m: of the wheel.
        drive_n, brake_n: its grip, see `contact.Grip`.
        commanded_radps: as set.
        target_rad: ``inf``: by velocity; else the angle to go to and hold.
        stopped: whether its robot is held, or has been taken off the field: it is braked, whatever is commanded.
        turns_radps: how fast it turns now.
        limit_n: the grip that was chosen for it.
        just_reversed: whether it has begun to turn this way in this tick.
        tendon: index of its grip in the model.
        at: where its angle stands in `qpos`, and its speed in `qvel`.
    """

    __slots__ = (
        "arm_m", "at", "brake_n", "commanded_radps", "drive_n", "just_reversed", "limit_n", "radius_m", "stopped",
        "target_rad", "tendon", "turns_radps",
    )  # fmt: skip

    def __init__(self, arm_m: float, radius_m: float, grip: contact.Grip, tendon: int, at: int) -> None:
        self.arm_m, self.radius_m = arm_m, radius_m
        self.tendon = tendon
        self.at = at
        self.drive_n, self.brake_n = grip.drive_n, grip.brake_n
        self.commanded_radps = 0.0
        self.target_rad = 0.0
        self.turns_radps = 0.0
        self.limit_n = -1.0
        self.just_reversed = False
        self.stopped = False


class WheelGrip(Effect):
    """The wheels of all robots. A wheel's index is twice its robot's, plus 1 on the right.

    MuJoCo's numbers are read and written one by one, through memory views: next to `mj_step` a handful of them takes
    half as long as one call of numpy (ADR 10).
    """

    def __init__(self, scene: Scene) -> None:
        model, data, tables, scenario = scene.model, scene.data, scene.tables, scene.scenario
        names, friction = scene.roster.entities[: scene.roster.robots], scenario.field.friction
        chassis = [scenario.kits[scenario.robots[name].kit].chassis for name in names]
        self._qpos, self._qvel = one_by_one(data.qpos), one_by_one(data.qvel)
        self._coefficients = one_by_one(model.wrap_prm)
        self._limits_n = one_by_one(model.tendon_frictionloss)
        self._wheels = [
            Wheel(
                way * one.wheel_track_m / 2,
                one.wheel_radius_m,
                contact.grip_of(one, friction),
                _TENDONS_PER_ROBOT * robot + 1 - way,
                tables.qpos_at[robot] + ROBOT_YAW + (1 if way == 1 else 2),
            )
            for robot, one in enumerate(chassis)
            for way in (1, -1)
        ]
        # By robot: where it stands in `qpos` and `qvel`, its coefficients that turn, and its wheels.
        self._robots = [
            (tables.qpos_at[robot], _COEFFICIENTS_PER_ROBOT * robot + _FIRST_TURNING, pair)
            for robot, pair in enumerate(zip(self._wheels[0::2], self._wheels[1::2], strict=True))
        ]
        self._ways = [
            (at, at + 1, at + ROBOT_YAW, turning, turning + 1, left.arm_m, right.arm_m)
            for at, turning, (left, right) in self._robots
        ]
        self._turning = [(at + ROBOT_YAW, self._coefficients.itemsize * turning) for at, turning, _ in self._robots]
        self._reversed: list[Wheel] = []
        # The speed that its whole grip stops in this time; without friction 0.
        self._stops_in_tick_mps = max(friction * contact.GRAVITY_MPS2 * TICK_S, 1e-9)
        self._stops_in_substep_mps = self._stops_in_tick_mps / SUBSTEPS_PER_TICK
        # Manoeuvres within a tick need no closer look. These take longer.
        self._fast = [
            robot
            for robot, one in zip(self._robots, chassis, strict=True)
            if one.max_wheel_radps * one.wheel_radius_m > self._stops_in_tick_mps
        ]
        self._on_the_way: list[int] = []

    def reset(self) -> None:
        """Hold every wheel where it is: none has been commanded yet."""
        for index, wheel in enumerate(self._wheels):
            wheel.stopped = False
            self._command(index, 0.0, self._angle(index))

    def set_wheel(self, robot: int, side: Side, velocity_radps: float, position_rad: float) -> None:
        """Command a wheel: by velocity (position ``inf``), or to an angle at this velocity at most."""
        index = 2 * robot + SIDES[side]
        wheel = self._wheels[index]
        if position_rad == wheel.target_rad == math.inf and not wheel.stopped:  # nearly always only the speed changes
            wheel.commanded_radps = velocity_radps
            self._turn(index, velocity_radps)
        else:
            self._command(index, velocity_radps, position_rad)

    def set_stopped(self, robot: int, *, stopped: bool) -> None:
        """Brake the wheels of a robot that is held or taken off the field; let them go on as commanded afterwards."""
        for index in (2 * robot, 2 * robot + 1):
            wheel = self._wheels[index]
            if wheel.stopped != stopped:
                wheel.stopped = stopped
                self._command(index, wheel.commanded_radps, wheel.target_rad)

    def before_substep(self, substep: int) -> None:
        """Turn the wheels as commanded, and let the grip follow the robots' yaw.

        Contacts change a wheel's speed by less than a millionth within the tick, but a collision changes the yaw by up
        to 0.3 rad.
        """
        if substep == 0:
            self._begin_tick()
        if self._on_the_way:
            self._steer_to_targets()
        self._turn_coefficients()
        if self._fast:
            self._choose_grip_of_fast()

    def _begin_tick(self) -> None:
        """Turn the wheels with the grip that they have at the robots' present speeds."""
        self._turn_all()
        self._choose_grip(self._speeds_along())
        for wheel in self._reversed:
            wheel.just_reversed = False
        self._reversed.clear()

    def _turn_coefficients(self) -> None:
        qpos, coefficients, write, cos = self._qpos, self._coefficients, _TURNING.pack_into, math.cos
        for yaw_at, first_byte in self._turning:
            yaw = qpos[yaw_at]
            ahead, aside = cos(yaw), cos(yaw - _QUARTER_TURN_RAD)
            write(coefficients, first_byte, ahead, aside, cos(yaw + _QUARTER_TURN_RAD), ahead, ahead, aside)

    def _speeds_along(self) -> list[float]:
        """Return how fast each wheel's position moves along its robot, by the robot's heading a sub-step ago."""
        qvel, coefficients = self._qvel, self._coefficients
        along_mps: list[float] = []
        for x_at, y_at, yaw_at, ahead, aside, left_arm_m, right_arm_m in self._ways:
            forward_mps = coefficients[ahead] * qvel[x_at] + coefficients[aside] * qvel[y_at]
            spin = qvel[yaw_at]
            along_mps += forward_mps - left_arm_m * spin, forward_mps - right_arm_m * spin
        return along_mps

    def _choose_grip(self, all_along_mps: list[float]) -> None:
        """A driving wheel has less grip than one that slows or holds its robot, see `contact.grip_of`."""
        for wheel, along_mps in zip(self._wheels, all_along_mps, strict=True):
            turns = wheel.turns_radps
            if turns == 0.0:
                limit_n = wheel.brake_n
            elif (along_mps >= 0.0) is (turns > 0.0):
                limit_n = wheel.drive_n
            else:
                limit_n = self._slowing_n(wheel, abs(along_mps))
            if limit_n != wheel.limit_n:
                wheel.limit_n = self._limits_n[wheel.tendon] = limit_n

    def _choose_grip_of_fast(self) -> None:
        """Choose again in each sub-step, and let what moves faster than its wheels be braked by them.

        Within a tick neither makes more of a difference than 20 ms. But a robot at 0.4 m/s that reversed was back at
        0.4 m/s after two thirds of the time that its grip needs, and one at 1 m/s was later at 0.5 m/s than at rest
        (ADR 2).
        """
        qvel, coefficients, limits_n = self._qvel, self._coefficients, self._limits_n
        for at, turning, pair in self._fast:
            forward_mps = coefficients[turning] * qvel[at] + coefficients[turning + 1] * qvel[at + 1]
            spin = qvel[at + ROBOT_YAW]
            for wheel in pair:
                along_mps = forward_mps - wheel.arm_m * spin
                turns_mps = wheel.turns_radps * wheel.radius_m
                if along_mps * turns_mps < 0.0:
                    share = min(1.0, abs(along_mps) / self._stops_in_substep_mps)
                    limits_n[wheel.tendon] = wheel.drive_n + share * (wheel.brake_n - wheel.drive_n)
                elif turns_mps == 0.0 or abs(along_mps) > abs(turns_mps) + _FASTER_MPS:
                    limits_n[wheel.tendon] = wheel.brake_n
                else:
                    limits_n[wheel.tendon] = wheel.drive_n

    def _slowing_n(self, wheel: Wheel, along_mps: float) -> float:
        """Return the grip of a wheel against which its robot moves, at this speed.

        If it has just been reversed, it has as much of its grip as gives the same speed at the end of the tick as
        changing over at the moment of standstill. Otherwise the robot is pushed against its wheels, and resists with
        all its grip but for the slowest speeds, so that it comes to rest.
        """
        stops_mps = self._stops_in_tick_mps if wheel.just_reversed else self._stops_in_substep_mps
        share = min(1.0, along_mps / stops_mps)
        return wheel.drive_n + share * (wheel.brake_n - wheel.drive_n)

    def _angle(self, index: int) -> float:
        return self._qpos[self._wheels[index].at]

    def _command(self, index: int, velocity_radps: float, target_rad: float) -> None:
        wheel = self._wheels[index]
        wheel.commanded_radps, wheel.target_rad = velocity_radps, target_rad
        if index in self._on_the_way:
            self._on_the_way.remove(index)
        by_velocity = math.isinf(target_rad)
        self._turn(index, velocity_radps if by_velocity and not wheel.stopped else 0.0)
        if not by_velocity and not wheel.stopped and self._angle(index) != target_rad:
            self._on_the_way.append(index)

    def _turn(self, index: int, radps: float) -> None:
        wheel = self._wheels[index]
        if wheel.turns_radps != radps:
            if wheel.turns_radps * radps <= 0:
                wheel.just_reversed = True
                self._reversed.append(wheel)
            wheel.turns_radps = radps

    def _turn_all(self) -> None:
        qvel = self._qvel
        for wheel in self._wheels:
            qvel[wheel.at] = wheel.turns_radps

    def _steer_to_targets(self) -> None:
        """Turn wheels that go to an angle; set those that have arrived on it."""
        for index in tuple(self._on_the_way):
            wheel = self._wheels[index]
            left_rad = wheel.target_rad - self._angle(index)
            if abs(left_rad) <= ARRIVED_RAD:
                self._qpos[wheel.at] = wheel.target_rad
                self._turn(index, 0.0)
                self._on_the_way.remove(index)
            else:
                limit = abs(wheel.commanded_radps)
                self._turn(index, max(-limit, min(limit, POSITION_GAIN_PS * left_rad)))
        self._turn_all()
