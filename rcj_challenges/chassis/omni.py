"""The chassis ``omni``: a body on wheels with rollers, which pull along their rims and slip freely across.

A wheel has no joint of its own: one joint per robot always turns at 1 rad/s, and a wheel's speed is the coefficient of
that joint in the slip of its grip. So all wheels of a robot cost one degree of freedom, and as many grips as they are.
"""

import math
from collections.abc import Iterable, Sequence
from itertools import combinations
from struct import Struct
from typing import Literal

from rcj_challenges.chassis.base import (
    GRAVITY_MPS2,
    YAW,
    Chassis,
    CommandedWheel,
    Drive,
    Grip,
    Mount,
    Physics,
    Shape,
    Wheel,
)
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.geometry.polygons import side
from rcj_challenges.rules.fields import Positive, described
from rcj_challenges.rules.phrasing import degrees, listed, metres_alike

_LEAST_SPAN = 0.2
"""Twice the area of the largest triangle of wheels on a circle of radius 1; that of three even wheels is 2.6. With
less, a wheel slips a lot for what little it moves the robot in some direction."""


class OmniChassis(Chassis):
    """A body on wheels with rollers: it drives in every direction, whichever way it looks."""

    drive: Literal["omni"]
    shape: Shape = described("round", "the body seen from above; flat_front: round, cut off at the front")
    max_wheel_radps: Positive = described(12.5, "highest wheel speed in rad/s; faster commands are clamped", le=100)
    # Source: those of most small-size robots (grSim, Parsian.ini); they leave the front free. The wheels fit into the
    # body, and their rims move as fast as those of the original's robot.
    wheels_at_rad: tuple[float, ...] = described(
        (1.0472, 2.3562, 3.927, 5.236),
        "where wheels 0, 1, … are, counter-clockwise from the front in rad; they drive counter-clockwise",
        min_length=3,
        max_length=8,
    )
    wheel_ring_m: Positive = described(0.028, "distance of the wheels from the centre in m", le=0.5)
    wheel_radius_m: Positive = described(0.016, "radius of the wheels in m", le=0.2)
    wheel_width_m: Positive = described(0.008, "width of the wheels in m", le=0.1)
    wheel_mass_kg: Positive = described(0.005, "mass of each wheel in kg", le=1)
    # With half, the usual four wheels accelerate with 0.39 g ahead and 0.3 g sideways, two tyres with 0.33 g ahead.
    grip: Positive = described(0.5, "friction of the rollers as a share of that of tyres", le=1)

    MOTOR_JOINT = "motor"
    EXAMPLE = """
kits:
  v2:
    chassis: {drive: omni, shape: flat_front, jaws_m: [0.005, 0.05]}
    devices:
      left wheel motor: {device: motor, wheel: 0}
      rear left motor: {device: motor, wheel: 1}
      rear right motor: {device: motor, wheel: 2}
      right wheel motor: {device: motor, wheel: 3}
      left wheel sensor: {device: wheel_sensor, wheel: 0}
      right wheel sensor: {device: wheel_sensor, wheel: 3}
"""

    def wheels(self) -> tuple[Wheel, ...]:
        """Return its wheels, which drive counter-clockwise around it."""
        size = self.wheel_radius_m, self.wheel_width_m, self.wheel_mass_kg
        ring_m = self.wheel_ring_m
        return tuple(
            Wheel(number, ring_m * math.cos(at), ring_m * math.sin(at), at + math.pi / 2, *size)
            for number, at in enumerate(self.wheels_at_rad)
        )

    @property
    def top_speed_mps(self) -> float:
        """How fast it drives at most, in the direction in which no wheel has to turn fast."""
        steepest = min(max(abs(math.sin(at - math.radians(way))) for at in self.wheels_at_rad) for way in range(180))
        return self.max_wheel_radps * self.wheel_radius_m / max(steepest, _LEAST_SPAN)

    def contradictions(self) -> Iterable[tuple[str, str]]:
        """Return the fields that contradict others: wheels that cannot drive it in every direction and turn it."""
        yield from super().contradictions()
        places = [(math.cos(at), math.sin(at)) for at in self.wheels_at_rad]
        if all(abs(side(*three)) < _LEAST_SPAN for three in combinations(places, 3)):
            yield (
                "wheels_at_rad",
                "no three of these wheels stand in different directions, so they cannot drive it both ways and turn it",
            )

    def grips(self, friction: float) -> tuple[Grip, ...]:
        """Return the grip along each wheel: its share of the weight; the rollers have none across."""
        wheels = self.wheels()
        weight_n = (self.mass_kg + len(wheels) * self.wheel_mass_kg) * GRAVITY_MPS2
        slip = {"x": 1.0, "y": 0.0, "yaw": self.wheel_ring_m, self.MOTOR_JOINT: 0.0}
        return tuple(
            Grip(f"{wheel.name}_grip", self.grip * friction * weight_n / len(wheels), slip) for wheel in wheels
        )

    @classmethod
    def make_drive(cls, physics: Physics, mounts: Sequence[Mount]) -> Drive:
        """The effect that drives all robots with such wheels in a half."""
        return OmniDrive(physics, [(mount, mount.chassis) for mount in mounts if isinstance(mount.chassis, cls)])

    def describe(self) -> str:
        """A description."""
        radius, width, ring = metres_alike((self.wheel_radius_m, self.wheel_width_m, self.wheel_ring_m))
        places = listed([degrees(at) for at in self.wheels_at_rad], "and")
        return (
            f"{self.body_words()} on {len(self.wheels_at_rad)} omni wheels at {places}, counter-clockwise from its "
            f"front; its mass is {self.mass_kg:g} kg, and {self.wheel_mass_kg:g} kg that of each wheel. The wheels "
            f"have a radius of {radius}, are {width} wide and {ring} from the centre, and hold with "
            f"{100 * self.grip:g} % of the friction of tyres; they turn at up to {self.max_wheel_radps:g} rad/s, "
            f"forward is counter-clockwise around the robot; at their best they drive it at {self.top_speed_mps:.3g} "
            f"m/s"
        )


class _RollerWheel(CommandedWheel):
    """One wheel with rollers.

    Attributes:
        row: cosine and sine of its direction, its arm, and minus how fast its rim moves.
    """

    __slots__ = ("_radius_m", "row")

    def __init__(self, at: int, wheel: Wheel, arm_m: float) -> None:
        super().__init__(at)
        self._radius_m = wheel.radius_m
        self.row = (math.cos(wheel.yaw_rad), math.sin(wheel.yaw_rad), arm_m, 0.0)

    def turn(self, radps: float) -> None:
        if self.turns_radps != radps:
            self.turns_radps = radps
            cos, sin, arm_m, _ = self.row
            self.row = cos, sin, arm_m, -self._radius_m * radps


class OmniDrive(Drive):
    """The wheels of all robots with omni wheels."""

    def __init__(self, physics: Physics, robots: Sequence[tuple[Mount, OmniChassis]]) -> None:
        wheels = {
            mount.robot: [
                _RollerWheel(at, wheel, chassis.wheel_ring_m) for at, wheel in enumerate(chassis.wheels(), mount.turned)
            ]
            for mount, chassis in robots
        }
        super().__init__(physics.turned_rad, wheels)
        self._qpos, self._qvel, self._coefficients = physics.qpos, physics.qvel, physics.coefficients
        # By robot: where it stands in `qpos` and `qvel`, its coefficients, what writes them, and its wheels.
        self._robots = [
            (mount.at, physics.coefficients.itemsize * mount.coefficient, Struct(f"{4 * len(some)}d").pack_into, some)
            for (mount, _), some in zip(robots, wheels.values(), strict=True)
        ]

    def before_substep(self, substep: int) -> None:
        """Turn the wheels as commanded, and let the grip follow the robots' yaw."""
        qpos, coefficients = self._qpos, self._coefficients
        if substep == 0:
            self._begin_tick()
        for at, first_byte, write, wheels in self._robots:
            yaw = qpos[at + YAW]
            c, s = math.cos(yaw), math.sin(yaw)
            numbers: list[float] = []
            for wheel in wheels:
                cos, sin, arm_m, rolls_mps = wheel.row
                numbers += c * cos - s * sin, s * cos + c * sin, arm_m, rolls_mps
            write(coefficients, first_byte, *numbers)

    def _begin_tick(self) -> None:
        self.steer_to_targets()
        for at, _, _, wheels in self._robots:
            self._qvel[at + YAW + 1] = 1.0
            for wheel in wheels:
                if wheel.turns_radps:
                    self._angles_rad[wheel.at] += wheel.turns_radps * TICK_S
