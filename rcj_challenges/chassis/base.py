"""What all chassis share: their fields, how body and wheels are described, and what drives them.

A robot moves in the plane (ADR 2): its joints are x, y and yaw, then those of its wheels. It looks along +x.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, ClassVar, Literal, NamedTuple

from pydantic import Field

from rcj_challenges.core.amounts import add_up
from rcj_challenges.geometry.polygons import Point, box, side, turned
from rcj_challenges.rules.base import Vocabulary, Word
from rcj_challenges.rules.fields import Positive, described
from rcj_challenges.rules.phrasing import metres

GRAVITY_MPS2 = 9.81
"""Standard gravity; the original's worlds use it too."""

YAW = 2
"""Where the yaw stands after x and y, in `qpos` and `qvel`; the joints of wheels follow."""

FRONT_M = 0.04
"""Width of what a robot has at its front: a ball whose centre is ahead of it is at the front."""

ROUNDING_M = 0.005
"""How much further back a ball may be that touches a round body beside its middle."""

WheelName = Literal["left", "right"] | Annotated[int, Field(ge=0)]
"""How a motor names its wheel; inside, wheels are numbered."""
WHEEL_NAMES = ": left (the robot's +y side) or right; of a chassis without such wheels its number, from 0"


def wheel_words(name: WheelName) -> str:
    """Return a wheel in words: ``the left wheel``, ``wheel 2``."""
    return f"wheel {name}" if isinstance(name, int) else f"the {name} wheel"


CHASSIS = Vocabulary("drive", otherwise="differential")


class Wheel(NamedTuple):
    """A wheel, seen from above.

    Attributes:
        name: as motors name it.
        x_m, y_m: its centre.
        yaw_rad: where it drives to if it turns forward.
        radius_m, width_m, mass_kg: its size.
    """

    name: WheelName
    x_m: float
    y_m: float
    yaw_rad: float
    radius_m: float
    width_m: float
    mass_kg: float

    @property
    def part(self) -> str:
        """The name of its outline on the robot, and of its joint: ``left_wheel``."""
        return f"{self.name}_wheel"

    def corners(self) -> tuple[Point, ...]:
        """Return its outline, counter-clockwise."""
        return turned(box(2 * self.radius_m, self.width_m), (self.x_m, self.y_m, self.yaw_rad))


class Grip(NamedTuple):
    """Dry friction on the floor against one slip.

    Attributes:
        name: ``left_grip``.
        limit_n: the largest force in N.
        slip: the slip's speed in m/s at yaw 0, as coefficients of the speeds of joints, in this order.
    """

    name: str
    limit_n: float
    slip: dict[str, float]


class Mount(NamedTuple):
    """A robot in the compiled model.

    Attributes:
        robot: its index.
        chassis: its chassis.
        at: where its x stands in `qpos` and `qvel`; its other joints follow.
        grip: index of its first grip in `limits_n`; the others follow.
        coefficient: where the first coefficient of its first grip stands; the others follow.
        turned: where the angles of its wheels without joints stand in `turned_rad`.
    """

    robot: int
    chassis: "Chassis"
    at: int
    grip: int
    coefficient: int
    turned: int


@dataclass(frozen=True)
class Physics:
    """The numbers of a world that drives read and write, one by one: numpy takes three times as long (ADR 10).

    Attributes:
        qpos, qvel: positions and speeds of joints.
        coefficients: of all grips.
        limits_n: of all grips.
        turned_rad: angles of wheels without joints.
        friction: between wheels and floor.
    """

    qpos: "memoryview[float]"
    qvel: "memoryview[float]"
    coefficients: "memoryview[float]"
    limits_n: "memoryview[float]"
    turned_rad: "memoryview[float]"
    friction: float


POSITION_GAIN_PS = 10.0
"""A wheel on its way to a target angle turns at gain times what is left. Source: the Webots reference, Motor: the
default of ``controlPID`` is a proportional gain of 10."""

ARRIVED_RAD = 1e-6
"""This close to its target angle a wheel is set on it and held."""


class CommandedWheel:
    """One wheel and its command.

    Attributes:
        at: where its angle stands among the angles of its drive.
        commanded_radps: as set.
        target_rad: ``inf``: by velocity; else the angle to go to and hold.
        stopped: whether its robot is held, or has been taken off the field: it is braked, whatever is commanded.
        turns_radps: how fast it turns now.
    """

    __slots__ = ("at", "commanded_radps", "stopped", "target_rad", "turns_radps")

    def __init__(self, at: int) -> None:
        self.at = at
        self.commanded_radps = 0.0
        self.target_rad = 0.0
        self.stopped = False
        self.turns_radps = 0.0

    def turn(self, radps: float) -> None:
        """Turn at this speed from now on."""
        raise NotImplementedError


class Drive:
    """The wheels of all robots with one kind of chassis, and their commands."""

    def __init__(self, angles_rad: "memoryview[float]", wheels: Mapping[int, Sequence[CommandedWheel]]) -> None:
        """Take the wheels of each robot by number, and the angles of all."""
        self._angles_rad, self._wheels = angles_rad, wheels
        self._on_the_way: list[CommandedWheel] = []

    def reset(self) -> None:
        """Hold every wheel where it is: none has been commanded yet."""
        for wheels in self._wheels.values():
            for wheel in wheels:
                wheel.stopped = False
                self._command(wheel, 0.0, self._angles_rad[wheel.at])

    def set_wheel(self, robot: int, wheel: int, velocity_radps: float, position_rad: float) -> None:
        """Command a wheel: by velocity (position ``inf``), or to an angle at this velocity at most."""
        one = self._wheels[robot][wheel]
        if position_rad == one.target_rad == math.inf and not one.stopped:  # nearly always only the speed changes
            one.commanded_radps = velocity_radps
            one.turn(velocity_radps)
        else:
            self._command(one, velocity_radps, position_rad)

    def set_stopped(self, robot: int, *, stopped: bool) -> None:
        """Brake the wheels of a robot that is held or taken off the field; let them go on as commanded afterwards."""
        for wheel in self._wheels[robot]:
            if wheel.stopped != stopped:
                wheel.stopped = stopped
                self._command(wheel, wheel.commanded_radps, wheel.target_rad)

    def before_substep(self, substep: int) -> None:
        """Turn the wheels as commanded, and let the grip follow the robots' yaw."""
        raise NotImplementedError

    def steer_to_targets(self) -> None:
        """Turn wheels that go to an angle; set those that have arrived on it."""
        for wheel in tuple(self._on_the_way):
            left_rad = wheel.target_rad - self._angles_rad[wheel.at]
            if abs(left_rad) <= ARRIVED_RAD:
                self._angles_rad[wheel.at] = wheel.target_rad
                wheel.turn(0.0)
                self._on_the_way.remove(wheel)
            else:
                limit = abs(wheel.commanded_radps)
                wheel.turn(max(-limit, min(limit, POSITION_GAIN_PS * left_rad)))

    def _command(self, wheel: CommandedWheel, velocity_radps: float, target_rad: float) -> None:
        wheel.commanded_radps, wheel.target_rad = velocity_radps, target_rad
        if wheel in self._on_the_way:
            self._on_the_way.remove(wheel)
        by_velocity = math.isinf(target_rad)
        wheel.turn(velocity_radps if by_velocity and not wheel.stopped else 0.0)
        if not by_velocity and not wheel.stopped and self._angles_rad[wheel.at] != target_rad:
            self._on_the_way.append(wheel)


Shape = Literal["box", "round", "flat_front"]

_SIDES = 16
"""A round body is a prism with so many sides: MuJoCo's cylinders are less exact at poles and cost more (ADR 2)."""

_FLAT_AT = 0.8
"""Where a round body is cut for a flat front, as a share of its radius: the front is 0.6 of the diameter wide, a little
more than the ball if that is 7.5 cm."""

_JAW_M = 0.005
"""Thickness of a jaw."""

_JawDepth = Annotated[float, Field(gt=0, le=0.05)]
_JawGap = Annotated[float, Field(gt=0, le=0.5)]


class Chassis(Word):
    """What carries a robot. The defaults are those of the original's robots.

    Attributes:
        MOTOR_JOINT: name of one joint for all wheels, which then have no joints of their own; empty: each has its own.
        FREE: the fields that designs of teams may choose, within the limits of size and mass.
    """

    KEY = "drive"
    MOTOR_JOINT: ClassVar = ""
    FREE: ClassVar = frozenset(
        {
            "size_m", "shape", "jaws_m", "mass_kg", "wheel_mass_kg", "wheel_width_m", "wheel_track_m", "wheels_at_rad",
            "wheel_ring_m",
        }
    )  # fmt: skip

    # Source of the defaults: reference, section 2.
    size_m: Positive = described(0.075, "edge length or diameter of the body in m, which is also its height", le=0.5)
    shape: Shape = described("box", "the body seen from above; flat_front: round, cut off at the front")
    jaws_m: tuple[_JawDepth, _JawGap] | None = described(
        None, "how far two jaws reach ahead of the body, and the distance between them, in m"
    )
    mass_kg: Positive = described(0.2, "mass of the body in kg", le=20)
    max_wheel_radps: Positive = described(10.0, "highest wheel speed in rad/s; faster commands are clamped", le=100)

    @property
    def height_m(self) -> float:
        """The height of its body."""
        return self.size_m

    @property
    def top_speed_mps(self) -> float:
        """How fast it drives at most."""
        return self.max_wheel_radps * max(wheel.radius_m for wheel in self.wheels())

    @property
    def front_m(self) -> float:
        """How far ahead of its centre its body ends."""
        return max(x for x, _ in self.body())

    @property
    def total_mass_kg(self) -> float:
        """Its mass with wheels."""
        return self.mass_kg + add_up(wheel.mass_kg for wheel in self.wheels())

    def mouth_m(self, ball_m: float) -> float:
        """The depth to which a ball of this radius enters between its jaws."""
        if self.jaws_m is None:
            return 0.0
        depth_m, half_m = self.jaws_m[0], self.jaws_m[1] / 2
        return depth_m if half_m >= ball_m else min(depth_m, ball_m - math.sqrt(ball_m**2 - half_m**2))

    def body(self) -> tuple[Point, ...]:
        """Return the outline of its body, convex and counter-clockwise."""
        if self.shape == "box":
            return box(self.size_m, self.size_m)
        is_round = self.shape == "round"
        first_rad, steps = (math.pi / _SIDES, _SIDES - 1) if is_round else (math.acos(_FLAT_AT), _SIDES - 3)
        angles = [first_rad + 2 * (math.pi - first_rad) * step / steps for step in range(steps + 1)]
        return tuple((self.size_m / 2 * math.cos(angle), self.size_m / 2 * math.sin(angle)) for angle in angles)

    def solids(self) -> dict[str, tuple[Point, ...]]:
        """Return the outlines of what is as high as its body, by name: convex and counter-clockwise."""
        solids = {"body": self.body()}
        if self.jaws_m is not None:
            tip_m, inner_m = self.front_m + self.jaws_m[0], self.jaws_m[1] / 2
            outer_m = inner_m + _JAW_M
            foot_m = self._reach_m(outer_m)
            solids["left_jaw"] = (tip_m, outer_m), (foot_m, outer_m), (foot_m, inner_m), (tip_m, inner_m)
            solids["right_jaw"] = (tip_m, -inner_m), (foot_m, -inner_m), (foot_m, -outer_m), (tip_m, -outer_m)
        return solids

    def _reach_m(self, beside_m: float) -> float:
        """The front of the body beside its middle; 0 outside of it."""
        body = self.body()
        crossed = (
            ax + (bx - ax) * (beside_m - ay) / (by - ay)
            for (ax, ay), (bx, by) in zip(body, (*body[1:], body[0]), strict=True)
            if min(ay, by) <= beside_m <= max(ay, by) and ay != by
        )
        return max(crossed, default=0.0)

    def wheels(self) -> tuple[Wheel, ...]:
        """Return its wheels by number."""
        raise NotImplementedError

    def number_of(self, wheel: WheelName) -> int:
        """Return the number of a wheel by its name."""
        return self.wheel_names().index(wheel)

    def lacking(self, wheel: WheelName) -> Iterable[tuple[str, str]]:
        """Return a wheel that it lacks, as a contradiction of a device."""
        names = self.wheel_names()
        if wheel not in names:
            yield "wheel", f"its chassis has no wheel {wheel}, but {', '.join(map(str, names))}"

    def contradictions(self) -> Iterable[tuple[str, str]]:
        """Return the fields that contradict others, each with what is wrong."""
        widest_m = self.size_m - 2 * _JAW_M
        if self.jaws_m is not None and self.jaws_m[1] > widest_m:
            yield "jaws_m", f"a body of {metres(self.size_m)} carries jaws up to {metres(max(0.0, widest_m))} apart"

    def sticks_out(self, wheel: Wheel) -> bool:
        """Return whether a wheel reaches beyond the body; if not, nothing touches it before the body."""
        body = self.body()
        edges = tuple(zip(body, (*body[1:], body[0]), strict=True))
        return any(side(*edge, corner) < 0 for edge in edges for corner in wheel.corners())

    def wheel_names(self) -> tuple[WheelName, ...]:
        """Return the names of its wheels by number."""
        return tuple(wheel.name for wheel in self.wheels())

    def footprint(self) -> Iterable[tuple[Point, ...]]:
        """Return convex polygons that cover body, jaws and wheels."""
        return *self.solids().values(), *(wheel.corners() for wheel in self.wheels())

    def grips(self, friction: float) -> tuple[Grip, ...]:
        """Return its grip on a floor."""
        raise NotImplementedError

    @classmethod
    def make_drive(cls, physics: Physics, mounts: Sequence[Mount]) -> Drive:
        """The effect that drives all robots with this kind of chassis in a half."""
        raise NotImplementedError

    def describe(self) -> str:
        """A description: ``a cube of 7.5 cm on two wheels; …``."""
        raise NotImplementedError

    def body_words(self) -> str:
        """Return its body in words: ``a cube of 7.5 cm``."""
        size = metres(self.size_m)
        words = {
            "box": f"a cube of {size}",
            "round": f"a round body, {size} wide and high,",
            "flat_front": f"a round body with a flat front, {size} wide and high,",
        }[self.shape]
        if self.jaws_m is None:
            return words
        return f"{words} with jaws that reach {metres(self.jaws_m[0])} ahead, {metres(self.jaws_m[1])} apart,"


def is_at_front(front_m: float, ahead_m: float, aside_m: float, radius_m: float, within_m: float) -> bool:
    """Return whether a ball is at the front of a robot.

    Args:
        front_m: how far ahead of the robot's centre its body ends.
        ahead_m: the ball's centre, ahead of the robot's.
        aside_m: how far left of the robot's middle it is.
        radius_m: of the ball.
        within_m: how large the gap may be. Beside the middle of a round body there may be less than none.
    """
    return abs(aside_m) <= FRONT_M / 2 and -ROUNDING_M <= ahead_m - front_m - radius_m <= within_m
