"""The chassis ``differential``: a cube on two wheels.

A motor is as in the original: so strong that only grip limits the robot. The wheel therefore turns exactly as
commanded, and dry friction between wheel and floor does the rest: along the left wheel, along the right wheel, and
across both.
"""

import math
from collections.abc import Iterable, Sequence
from struct import Struct
from typing import Literal

from rcj_challenges.chassis.base import GRAVITY_MPS2, YAW, Chassis, Drive, Grip, Mount, Physics, Wheel
from rcj_challenges.core.timing import SUBSTEPS_PER_TICK, TICK_S
from rcj_challenges.geometry.polygons import Point, box
from rcj_challenges.rules.fields import Positive, described
from rcj_challenges.rules.phrasing import metres_alike


class DifferentialChassis(Chassis):
    """A cube on two wheels. The defaults are those of the original's robots."""

    drive: Literal["differential"] = "differential"
    wheel_radius_m: Positive = described(0.02, "radius of the wheels in m", le=0.2)
    wheel_width_m: Positive = described(0.01, "width of the wheels in m", le=0.1)
    wheel_track_m: Positive = described(0.09, "distance between the centres of the wheels in m", le=0.6)
    wheel_mass_kg: Positive = described(0.005, "mass of each wheel in kg", le=1)

    EXAMPLE = """
kits:
  v2: {chassis: {wheel_track_m: 0.1, max_wheel_radps: 8, jaws_m: [0.01, 0.05]}}
"""
    SENTENCE = (
        "a cube of 7.5 cm with jaws that reach 1 cm ahead, 5 cm apart, on two wheels; its mass is 0.2 kg, and 0.005 kg "
        "that of each wheel. The wheels have a radius of 2 cm, are 1 cm wide and 10 cm apart, from centre to centre; "
        "they turn at up to 8 rad/s, which drives it at 0.16 m/s"
    )

    def wheels(self) -> tuple[Wheel, ...]:
        """Return its wheels: ``left`` is +y of the robot that looks along +x."""
        size = self.wheel_radius_m, self.wheel_width_m, self.wheel_mass_kg
        left_m = self.wheel_track_m / 2
        return Wheel("left", 0.0, left_m, 0.0, *size), Wheel("right", 0.0, -left_m, 0.0, *size)

    def footprint(self) -> Iterable[tuple[Point, ...]]:
        """Return body and jaws, and the box that both wheels reach."""
        return *self.solids().values(), box(2 * self.wheel_radius_m, self.wheel_track_m + self.wheel_width_m)

    def grip_n(self, friction: float) -> tuple[float, float, float]:
        """Return the grip per wheel while it drives, per wheel while it slows or holds the robot, and across, in N.

        The original's robot has no caster: pushed on by its wheels it leans on the lower rear edge of its cube, which
        drags. With the centre of mass as high as the edge is far behind the axle, a load of m·a rests on the edge, and
        m·a = friction · (weight - m·a) - friction · m·a, so m·a = friction · weight / (1 + 2 friction): g/3 at
        friction 1, as the reference says (section 2). When it brakes or is pushed, wheels and edges all hold it.
        """
        weight_n = (self.mass_kg + 2 * self.wheel_mass_kg) * GRAVITY_MPS2
        full_n = friction * weight_n
        return full_n / (1 + 2 * friction) / 2, full_n / 2, full_n

    def grips(self, friction: float) -> tuple[Grip, ...]:
        """Return the grip along each wheel and across both.

        The slip at a wheel is the forward speed of the cube, less what turning takes off at the wheel, less what the
        wheel rolls; across, it is the speed of the axle's middle to the left. Dry friction in each is bounded
        separately (a box, as in the original).
        """
        _, brake_n, side_n = self.grip_n(friction)
        arm_m, radius_m = self.wheel_track_m / 2, self.wheel_radius_m
        # In this order the six numbers that change with the yaw stand side by side.
        return (
            Grip("left_grip", brake_n, {"yaw": -arm_m, "left_wheel": -radius_m, "x": 1.0, "y": 0.0}),
            Grip("side_grip", side_n, {"x": 0.0, "y": 1.0}),
            Grip("right_grip", brake_n, {"x": 1.0, "y": 0.0, "yaw": arm_m, "right_wheel": -radius_m}),
        )

    @classmethod
    def make_drive(cls, physics: Physics, mounts: Sequence[Mount]) -> Drive:
        """The effect that drives all robots with two wheels in a half."""
        return DifferentialDrive(
            physics, [(mount, mount.chassis) for mount in mounts if isinstance(mount.chassis, cls)]
        )

    def describe(self) -> str:
        """A description."""
        apart, radius, width = metres_alike((self.wheel_track_m, self.wheel_radius_m, self.wheel_width_m))
        return (
            f"{self.body_words()} on two wheels; its mass is {self.mass_kg:g} kg, and "
            f"{self.wheel_mass_kg:g} kg that of each wheel. The wheels have a radius of {radius}, are {width} wide and "
            f"{apart} apart, from centre to centre; they turn at up to {self.max_wheel_radps:g} rad/s, which "
            f"drives it at {self.top_speed_mps:g} m/s"
        )


POSITION_GAIN_PS = 10.0
"""A wheel on its way to a target angle turns at gain times what is left. Source: the Webots reference, Motor: the
default of ``controlPID`` is a proportional gain of 10."""

ARRIVED_RAD = 1e-6
"""This close to its target angle a wheel is set on it and held."""

_FIRST_TURNING = 2
"""Index of the first of a robot's six coefficients that turn with it: left wheel x, y; across x, y; right wheel x,
y."""
_TURNING = Struct("6d")

_QUARTER_TURN_RAD = math.pi / 2

_FASTER_MPS = 1e-3
"""A robot that is faster than its wheel by more than this is slowed down by it."""


class CommandedWheel:
    """One wheel and its command.

    Attributes:
        arm_m: how far left of the cube's centre it is; negative on the right.
        radius_m: of the wheel.
        drive_n, brake_n: its grip, see `DifferentialChassis.grip_n`.
        commanded_radps: as set.
        target_rad: ``inf``: by velocity; else the angle to go to and hold.
        stopped: whether its robot is held, or has been taken off the field: it is braked, whatever is commanded.
        turns_radps: how fast it turns now.
        limit_n: the grip that was chosen for it.
        just_reversed: whether it has begun to turn this way in this tick.
        grip: where the limit of its grip stands.
        at: where its angle stands in `qpos`, and its speed in `qvel`.
    """

    __slots__ = (
        "arm_m", "at", "brake_n", "commanded_radps", "drive_n", "grip", "just_reversed", "limit_n", "radius_m",
        "stopped", "target_rad", "turns_radps",
    )  # fmt: skip

    def __init__(self, arm_m: float, radius_m: float, grip_n: tuple[float, float], grip: int, at: int) -> None:
        self.arm_m, self.radius_m = arm_m, radius_m
        self.grip = grip
        self.at = at
        self.drive_n, self.brake_n = grip_n
        self.commanded_radps = 0.0
        self.target_rad = 0.0
        self.turns_radps = 0.0
        self.limit_n = -1.0
        self.just_reversed = False
        self.stopped = False


class DifferentialDrive:
    """The wheels of all robots with two wheels."""

    def __init__(self, physics: Physics, robots: Sequence[tuple[Mount, DifferentialChassis]]) -> None:
        self._qpos, self._qvel = physics.qpos, physics.qvel
        self._coefficients, self._limits_n = physics.coefficients, physics.limits_n
        self._pairs = {
            mount.robot: tuple(
                CommandedWheel(
                    wheel.y_m,
                    wheel.radius_m,
                    chassis.grip_n(physics.friction)[:2],
                    mount.grip + 2 * number,
                    mount.at + YAW + 1 + number,
                )
                for number, wheel in enumerate(chassis.wheels())
            )
            for mount, chassis in robots
        }
        self._wheels = [wheel for pair in self._pairs.values() for wheel in pair]
        # By robot: where it stands in `qpos` and `qvel`, its coefficients that turn, and its wheels.
        self._robots = [
            (mount.at, mount.coefficient + _FIRST_TURNING, pair)
            for (mount, _), pair in zip(robots, self._pairs.values(), strict=True)
        ]
        self._ways = [
            (at, at + 1, at + YAW, turning, turning + 1, left.arm_m, right.arm_m)
            for at, turning, (left, right) in self._robots
        ]
        self._turning = [(at + YAW, self._coefficients.itemsize * turning) for at, turning, _ in self._robots]
        self._reversed: list[CommandedWheel] = []
        # The speed that its whole grip stops in this time; without friction 0.
        self._stops_in_tick_mps = max(physics.friction * GRAVITY_MPS2 * TICK_S, 1e-9)
        self._stops_in_substep_mps = self._stops_in_tick_mps / SUBSTEPS_PER_TICK
        # Manoeuvres within a tick need no closer look. These take longer.
        self._fast = [
            robot
            for robot, (_, chassis) in zip(self._robots, robots, strict=True)
            if chassis.top_speed_mps > self._stops_in_tick_mps
        ]
        self._on_the_way: list[CommandedWheel] = []

    def reset(self) -> None:
        """Hold every wheel where it is: none has been commanded yet."""
        for wheel in self._wheels:
            wheel.stopped = False
            self._command(wheel, 0.0, self._qpos[wheel.at])

    def set_wheel(self, robot: int, wheel: int, velocity_radps: float, position_rad: float) -> None:
        """Command a wheel: by velocity (position ``inf``), or to an angle at this velocity at most."""
        one = self._pairs[robot][wheel]
        if position_rad == one.target_rad == math.inf and not one.stopped:  # nearly always only the speed changes
            one.commanded_radps = velocity_radps
            self._turn(one, velocity_radps)
        else:
            self._command(one, velocity_radps, position_rad)

    def set_stopped(self, robot: int, *, stopped: bool) -> None:
        """Brake the wheels of a robot that is held or taken off the field; let them go on as commanded afterwards."""
        for wheel in self._pairs[robot]:
            if wheel.stopped != stopped:
                wheel.stopped = stopped
                self._command(wheel, wheel.commanded_radps, wheel.target_rad)

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
        """The speed of each wheel's position along its robot, by the robot's heading a sub-step ago."""
        qvel, coefficients = self._qvel, self._coefficients
        along_mps: list[float] = []
        for x_at, y_at, yaw_at, ahead, aside, left_arm_m, right_arm_m in self._ways:
            forward_mps = coefficients[ahead] * qvel[x_at] + coefficients[aside] * qvel[y_at]
            spin = qvel[yaw_at]
            along_mps += forward_mps - left_arm_m * spin, forward_mps - right_arm_m * spin
        return along_mps

    def _choose_grip(self, all_along_mps: list[float]) -> None:
        """A driving wheel has less grip than one that slows or holds its robot, see `DifferentialChassis.grip_n`."""
        for wheel, along_mps in zip(self._wheels, all_along_mps, strict=True):
            turns = wheel.turns_radps
            if turns == 0.0:
                limit_n = wheel.brake_n
            elif (along_mps >= 0.0) is (turns > 0.0):
                limit_n = wheel.drive_n
            else:
                limit_n = self._slowing_n(wheel, abs(along_mps))
            if limit_n != wheel.limit_n:
                wheel.limit_n = self._limits_n[wheel.grip] = limit_n

    def _choose_grip_of_fast(self) -> None:
        """Choose again in each sub-step, and let what moves faster than its wheels be braked by them.

        Within a tick neither makes more of a difference than 20 ms. But a robot at 0.4 m/s that reversed was back at
        0.4 m/s after two thirds of the time that its grip needs, and one at 1 m/s was later at 0.5 m/s than at rest
        (ADR 2).
        """
        qvel, coefficients, limits_n = self._qvel, self._coefficients, self._limits_n
        for at, turning, pair in self._fast:
            forward_mps = coefficients[turning] * qvel[at] + coefficients[turning + 1] * qvel[at + 1]
            spin = qvel[at + YAW]
            for wheel in pair:
                along_mps = forward_mps - wheel.arm_m * spin
                turns_mps = wheel.turns_radps * wheel.radius_m
                if along_mps * turns_mps < 0.0:
                    share = min(1.0, abs(along_mps) / self._stops_in_substep_mps)
                    limits_n[wheel.grip] = wheel.drive_n + share * (wheel.brake_n - wheel.drive_n)
                elif turns_mps == 0.0 or abs(along_mps) > abs(turns_mps) + _FASTER_MPS:
                    limits_n[wheel.grip] = wheel.brake_n
                else:
                    limits_n[wheel.grip] = wheel.drive_n

    def _slowing_n(self, wheel: CommandedWheel, along_mps: float) -> float:
        """Return the grip of a wheel against which its robot moves, at this speed.

        If it has just been reversed, it has as much of its grip as gives the same speed at the end of the tick as
        changing over at the moment of standstill. Otherwise the robot is pushed against its wheels, and resists with
        all its grip but for the slowest speeds, so that it comes to rest.
        """
        stops_mps = self._stops_in_tick_mps if wheel.just_reversed else self._stops_in_substep_mps
        share = min(1.0, along_mps / stops_mps)
        return wheel.drive_n + share * (wheel.brake_n - wheel.drive_n)

    def _command(self, wheel: CommandedWheel, velocity_radps: float, target_rad: float) -> None:
        wheel.commanded_radps, wheel.target_rad = velocity_radps, target_rad
        if wheel in self._on_the_way:
            self._on_the_way.remove(wheel)
        by_velocity = math.isinf(target_rad)
        self._turn(wheel, velocity_radps if by_velocity and not wheel.stopped else 0.0)
        if not by_velocity and not wheel.stopped and self._qpos[wheel.at] != target_rad:
            self._on_the_way.append(wheel)

    def _turn(self, wheel: CommandedWheel, radps: float) -> None:
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
        for wheel in tuple(self._on_the_way):
            left_rad = wheel.target_rad - self._qpos[wheel.at]
            if abs(left_rad) <= ARRIVED_RAD:
                self._qpos[wheel.at] = wheel.target_rad
                self._turn(wheel, 0.0)
                self._on_the_way.remove(wheel)
            else:
                limit = abs(wheel.commanded_radps)
                self._turn(wheel, max(-limit, min(limit, POSITION_GAIN_PS * left_rad)))
        self._turn_all()
