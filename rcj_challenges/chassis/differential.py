"""The chassis ``differential``: a cube on two wheels.

A motor is as in the original: so strong that only grip limits the robot. The wheel therefore turns exactly as
commanded, and dry friction between wheel and floor does the rest: along the left wheel, along the right wheel, and
across both.
"""

import math
from collections.abc import Iterable, Iterator, Sequence
from struct import Struct
from typing import Literal

from rcj_challenges.chassis.base import GRAVITY_MPS2, YAW, Chassis, CommandedWheel, Drive, Grip, Mount, Physics, Wheel
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


_FIRST_TURNING = 2
"""Index of the first of a robot's six coefficients that turn with it: left wheel x, y; across x, y; right wheel x,
y."""
_TURNING = Struct("6d")

_QUARTER_TURN_RAD = math.pi / 2

_FASTER_MPS = 1e-3
"""A robot that is faster than its wheel by more than this is slowed down by it."""


class _GrippingWheel(CommandedWheel):
    """One wheel of two.

    Attributes:
        arm_m: how far left of the cube's centre it is; negative on the right.
        radius_m: of the wheel.
        drive_n, brake_n: its grip, see `DifferentialChassis.grip_n`.
        just_reversed: whether it has begun to turn this way in this tick.
        grip: where the limit of its grip stands.
    """

    __slots__ = ("arm_m", "brake_n", "drive_n", "grip", "just_reversed", "radius_m")

    def __init__(self, mount: Mount, number: int, wheel: Wheel, grip_n: tuple[float, float, float]) -> None:
        super().__init__(mount.at + YAW + 1 + number)
        self.arm_m, self.radius_m = wheel.y_m, wheel.radius_m
        self.drive_n, self.brake_n, _ = grip_n
        self.just_reversed = False
        self.grip = mount.grip + 2 * number

    def turn(self, radps: float) -> None:
        if self.turns_radps != radps:
            self.just_reversed = self.just_reversed or self.turns_radps * radps <= 0
            self.turns_radps = radps

    def slowing_n(self, along_mps: float, stops_mps: float) -> float:
        """Return its grip if its robot moves against it at this speed: all of it from the second speed on."""
        share = min(1.0, abs(along_mps) / stops_mps)
        return self.drive_n + share * (self.brake_n - self.drive_n)


_Robot = tuple[int, int, Sequence[_GrippingWheel]]
"""Where a robot stands in `qpos` and `qvel`, its coefficients that turn, and its wheels."""


class DifferentialDrive(Drive):
    """The wheels of all robots with two wheels."""

    def __init__(self, physics: Physics, robots: Sequence[tuple[Mount, DifferentialChassis]]) -> None:
        wheels = {
            mount.robot: tuple(
                _GrippingWheel(mount, number, wheel, chassis.grip_n(physics.friction))
                for number, wheel in enumerate(chassis.wheels())
            )
            for mount, chassis in robots
        }
        super().__init__(physics.qpos, wheels)
        self._qpos, self._qvel = physics.qpos, physics.qvel
        self._coefficients, self._limits_n = physics.coefficients, physics.limits_n
        self._robots: list[_Robot] = [
            (mount.at, mount.coefficient + _FIRST_TURNING, wheels[mount.robot]) for mount, _ in robots
        ]
        self._all = [wheel for _, _, some in self._robots for wheel in some]
        self._turning = [(at + YAW, self._coefficients.itemsize * turning) for at, turning, _ in self._robots]
        # The speed that its whole grip stops in this time; without friction 0.
        self._stops_in_tick_mps = max(physics.friction * GRAVITY_MPS2 * TICK_S, 1e-9)
        self._stops_in_substep_mps = self._stops_in_tick_mps / SUBSTEPS_PER_TICK
        # Manoeuvres within a tick need no closer look. These take longer.
        self._fast = [
            robot
            for robot, (_, chassis) in zip(self._robots, robots, strict=True)
            if chassis.top_speed_mps > self._stops_in_tick_mps
        ]

    def before_substep(self, substep: int) -> None:
        """Turn the wheels as commanded, and let the grip follow the robots' yaw.

        Contacts change a wheel's speed by less than a millionth within the tick, but a collision changes the yaw by up
        to 0.3 rad.
        """
        if substep == 0:
            self._turn_all()
            self._choose_grip()
        if self._on_the_way:
            self.steer_to_targets()
            self._turn_all()
        self._turn_coefficients()
        if self._fast:
            self._choose_grip_of_fast()

    def _turn_all(self) -> None:
        qvel = self._qvel
        for wheel in self._all:
            qvel[wheel.at] = wheel.turns_radps

    def _turn_coefficients(self) -> None:
        qpos, coefficients, write, cos = self._qpos, self._coefficients, _TURNING.pack_into, math.cos
        for yaw_at, first_byte in self._turning:
            yaw = qpos[yaw_at]
            ahead, aside = cos(yaw), cos(yaw - _QUARTER_TURN_RAD)
            write(coefficients, first_byte, ahead, aside, cos(yaw + _QUARTER_TURN_RAD), ahead, ahead, aside)

    def _speeds_along(self, robots: Sequence[_Robot]) -> Iterator[tuple[_GrippingWheel, float]]:
        """Yield each wheel with the speed of its position along its robot, by the heading in the coefficients."""
        qvel, coefficients = self._qvel, self._coefficients
        for at, turning, wheels in robots:
            forward_mps = coefficients[turning] * qvel[at] + coefficients[turning + 1] * qvel[at + 1]
            spin = qvel[at + YAW]
            for wheel in wheels:
                yield wheel, forward_mps - wheel.arm_m * spin

    def _choose_grip(self) -> None:
        """Give wheels the grip that they have at the robots' present speeds.

        A driving wheel has less grip than one that slows or holds its robot, see `DifferentialChassis.grip_n`. If it
        has just been reversed, it has as much of its grip as gives the same speed at the end of the tick as changing
        over at the moment of standstill. Otherwise a robot that moves against its wheels is pushed, and resists with
        all its grip but for the slowest speeds, so that it comes to rest.
        """
        limits_n = self._limits_n
        for wheel, along_mps in self._speeds_along(self._robots):
            turns = wheel.turns_radps
            if turns == 0.0:
                limit_n = wheel.brake_n
            elif (along_mps >= 0.0) is (turns > 0.0):
                limit_n = wheel.drive_n
            else:
                stops_mps = self._stops_in_tick_mps if wheel.just_reversed else self._stops_in_substep_mps
                limit_n = wheel.slowing_n(along_mps, stops_mps)
            limits_n[wheel.grip] = limit_n
            wheel.just_reversed = False

    def _choose_grip_of_fast(self) -> None:
        """Choose again in each sub-step, and let what moves faster than its wheels be braked by them.

        Within a tick neither makes more of a difference than 20 ms. But a robot at 0.4 m/s that reversed was back at
        0.4 m/s after two thirds of the time that its grip needs, and one at 1 m/s was later at 0.5 m/s than at rest
        (ADR 2).
        """
        limits_n = self._limits_n
        for wheel, along_mps in self._speeds_along(self._fast):
            turns_mps = wheel.turns_radps * wheel.radius_m
            if along_mps * turns_mps < 0.0:
                limit_n = wheel.slowing_n(along_mps, self._stops_in_substep_mps)
            elif turns_mps == 0.0 or abs(along_mps) > abs(turns_mps) + _FASTER_MPS:
                limit_n = wheel.brake_n
            else:
                limit_n = wheel.drive_n
            limits_n[wheel.grip] = limit_n
