"""What all devices share: how they are listed, described to programs, and made into sensors.

A device is one file: the model of a kit's entry, its sensor with its noise, what a program is given before it starts,
what recordings and replay pages keep of its readings, its line on the rule sheet, and its example. Such a file knows
neither scenario nor MuJoCo, only the protocols here.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple, Protocol, Self

from rcj_challenges.chassis.base import Chassis
from rcj_challenges.core.play import HalfInfo
from rcj_challenges.core.traffic import DeviceSpec
from rcj_challenges.devices.poses import RobotPose, Vector
from rcj_challenges.rules.base import Vocabulary, Word

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

Reader = Callable[[int, RobotPose, list[float]], None]
"""Writes the samples of a tick into a robot's numbers, like `Sensor.read`."""

Rgb = tuple[int, int, int]

DEVICES = Vocabulary("device")


@dataclass(frozen=True)
class RobotSetup:
    """What a device needs of its robot.

    Attributes:
        messages: form of the referee's packets, as in the kit.
        packet_every_ticks: how often the referee sends one.
        max_packet_bytes: of the largest radio packet.
        own_channel, foreign_channels: of its team's radio, and of those of other teams.
        referee_channels: those on which the referee sends to it.
        open_channels: those on which the referee receives from it.
    """

    chassis: Chassis
    messages: str
    packet_every_ticks: int
    max_packet_bytes: int
    own_channel: int
    foreign_channels: tuple[int, ...]
    referee_channels: tuple[int, ...]
    open_channels: tuple[int, ...]


@dataclass(frozen=True)
class Fitted:
    """A device in its place on a robot.

    Attributes:
        robot: index of the robot in the roster.
        device: its entry in the scenario.
        spec: what the program is given of it.
    """

    robot: int
    robot_name: str
    device: "Device"
    spec: DeviceSpec
    setup: RobotSetup


class FixedRay(NamedTuple):
    """A horizontal ray that turns with its robot.

    Attributes:
        bearing_rad: counter-clockwise from the front.
        offset_m: where it starts, from the centre along the bearing.
        above_centre_m: how much higher than the centre of its body.
    """

    robot_name: str
    device_name: str
    bearing_rad: float
    offset_m: float
    above_centre_m: float


class FixedRays(Protocol):
    """The fixed rays of all robots, measured together."""

    def measure(self) -> list[tuple[float, ...]]:
        """Return distance in m, direction (3) and normal of what is met (3) of each ray; the normal of nothing is 0."""


class RayFan(Protocol):
    """Rays from one point, cast together.

    Attributes:
        origin: [3], in m; to be set before they are cast.
        directions: [N, 3] unit vectors; to be set before they are cast.
    """

    origin: "NDArray[np.float64]"
    directions: "NDArray[np.float64]"

    def cast(self, count: int) -> "NDArray[np.float64]":
        """Return the lengths of the first ``count`` rays in m (negative: nothing is met); overwritten next time."""


@dataclass(frozen=True)
class Eye:
    """Where a camera sits and what it takes in; it looks level.

    Attributes:
        bearing_rad: where it looks, counter-clockwise from the front.
        ahead_m: how far it sits from the robot's centre, along the bearing.
        height_m: above the floor.
        width, height: of its pictures, in pixels.
        fov_rad: what a picture shows from left to right; from pi on it is a panorama of equal angles.
        down: share of the rows that lie below the horizon.
    """

    bearing_rad: float
    ahead_m: float
    height_m: float
    width: int
    height: int
    fov_rad: float
    down: float

    @property
    def lens(self) -> tuple[int, int, float, float, float]:
        """What decides the rays of a picture: pictures with the same are taken together."""
        return self.width, self.height, self.fov_rad, self.down, self.height_m


class Seen(NamedTuple):
    """What a camera recognizes, in the camera's frame: x ahead, y left, z up.

    Attributes:
        number: of the thing, the same in all pictures of a half.
        model: ``robot``, ``ball`` or ``obstacle``.
        rgb: its colour, red, green and blue.
        position: of its middle, in m.
        yaw_rad: where its front looks; 0 of what is round.
        width_m, height_m: how wide it is across the camera's direction, and how high.
        box: what is visible of it, in pixels: left, top, width and height.
    """

    number: int
    model: str
    rgb: Rgb
    position: Vector
    yaw_rad: float
    width_m: float
    height_m: float
    box: tuple[int, int, int, int]


class Rays(Protocol):
    """What sensors see of the world."""

    def number_of(self, robot_name: str, device_name: str) -> int:
        """Return the number of a device's fixed ray among `FixedRays.measure`."""

    def fixed(self, height_m: float) -> FixedRays:
        """Return the fixed rays, which see what rays at this height see."""

    def fan(self, robot_name: str, height_m: float, max_m: float, rays: int) -> RayFan:
        """Return a fan of a robot at a height, which does not see that robot."""

    def reaches(self, robot: int, origin: Vector, along: Vector) -> bool:
        """Return whether a ray first meets this robot, or nothing; it passes through balls."""


class Sight(Protocol):
    """Takes the pictures of cameras."""

    @property
    def palette(self) -> list[Rgb]:
        """Red, green and blue of each number that stands in pictures."""

    def take(self, eyes: "Sequence[tuple[int, Eye]]") -> list[bytes]:
        """Return a picture from each eye, on the robot of this index: a number of the palette per pixel, row by row.

        All eyes have the same lens.
        """

    def recognize(self, eyes: "Sequence[tuple[int, Eye]]") -> list[list[Seen]]:
        """Return what each eye recognizes, on the robot of this index: the nearest first."""

    def brightness(self, x_m: float, y_m: float) -> float:
        """Return the brightness of the floor at a place, from 0 to 1."""


class Joints(Protocol):
    """Angles, places and touches of this tick; balls by their centres."""

    state: list[float]
    balls: list[Vector]
    radii_m: list[float]

    def velocity(self, robot: int) -> Vector:
        """Return the speed of a robot along x and y of the field, in m/s, and about z, in rad/s."""

    def touched_at(self, robot: int) -> Sequence[float]:
        """Return the bearings at which a robot touched walls, obstacles and robots in this tick, in its frame."""

    def wheel_angle_at(self, robot: int, wheel: int) -> int:
        """Return the place of a wheel's angle in `state`; it grows while the wheel drives forward."""


class Movers(Protocol):
    """What motors drive."""

    def set_wheel(self, robot: int, wheel: int, velocity_radps: float, position_rad: float) -> None:
        """Command a wheel by its number; positive drives forward; position ``inf``: by velocity."""

    def set_tool(self, robot: int, name: str, velocity: float, position: float) -> None:
        """Command what is no wheel by the name of its device."""


class Motion(NamedTuple):
    """How a motor is commanded.

    Attributes:
        command: given velocity and position.
        direction: what both are multiplied by before, 1 or -1.
        limit: the highest velocity.
    """

    command: Callable[[float, float], None]
    direction: int
    limit: float


@dataclass(frozen=True)
class SensorContext:
    """What sensors are made of in one half; the joints are refreshed every tick."""

    half: HalfInfo
    rays: Rays
    joints: Joints
    make_sight: Callable[[], Sight]


class Sensor:
    """One sensor of one robot.

    Attributes:
        BLANK: what it reads before its first sample.
        slot, width: where its numbers are among those of its robot.
        advances: whether `advance` is to be called.
    """

    __slots__ = ("advances", "slot", "width")

    BLANK: ClassVar[float] = math.nan

    def __init__(self, spec: DeviceSpec) -> None:
        self.slot = spec.slot
        self.width = spec.width
        self.advances = False

    def read(self, tick: int, pose: RobotPose, values: list[float]) -> None:
        """Write the sample of a tick into its robot's numbers."""
        raise NotImplementedError

    @classmethod
    def reader(cls, sensors: Sequence[Self]) -> Reader:
        """Return a function that reads some sensors of one robot; common kinds do it in one loop (ADR 10)."""
        if len(sensors) == 1:
            return sensors[0].read

        def read(tick: int, pose: RobotPose, values: list[float]) -> None:
            for sensor in sensors:
                sensor.read(tick, pose, values)

        return read

    def advance(self, tick: int, pose: RobotPose) -> None:
        """Move on by one tick while enabled, also between samples and before them."""

    def set_frequency(self, frequency_hz: float) -> None:
        """Set how fast it turns, if it does."""

    def clear(self, values: list[float]) -> None:
        """Forget all samples, in its robot's numbers too."""
        values[self.slot : self.slot + self.width] = [self.BLANK] * self.width


class Device(Word):
    """An entry of a kit's ``devices``.

    Attributes:
        CLASS: the class of the object that ``getDevice`` returns, in snake_case.
        ACCEPTS: the lists of a `Request` in which a program may name it.
        WIDTH: how many numbers a sample has.
        RESOLUTION: what replay pages round its numbers to.
        MAX_SHOWN: how many of its numbers a replay page carries; the rest is skipped evenly.
        PAGE_FACTS: which facts a replay page needs to draw it.
        FREE: the fields that designs of teams may choose freely, because nothing is gained by them.
    """

    KEY = "device"
    CLASS: ClassVar = ""
    ACCEPTS: ClassVar[frozenset[str]] = frozenset()
    WIDTH: ClassVar = 0
    RESOLUTION: ClassVar = 1e-3
    MAX_SHOWN: ClassVar = 1_000_000
    PAGE_FACTS: ClassVar[tuple[str, ...]] = ()
    FREE: ClassVar[frozenset[str]] = frozenset()

    def place(self) -> Vector | None:
        """Return where it sits: ahead and left of the robot's centre, and above the floor; None: anywhere within."""
        return None

    def looks(self) -> tuple[float, float] | None:
        """Return its bearing and the angle that it takes in, in rad; None: it looks at nothing."""
        return None

    @property
    def numbers(self) -> int:
        """How many numbers a sample has."""
        return self.WIDTH

    def facts(self, _setup: RobotSetup) -> dict[str, Any]:
        """Return the values that a program can ask for without stepping, JSON-able."""
        return {}

    def contradictions(self, _chassis: Chassis) -> Iterable[tuple[str, str]]:
        """Return the fields that contradict others or the robot's chassis, each with what is wrong."""
        return ()

    def fixed_ray(self, _robot_name: str, _name: str, _setup: RobotSetup) -> FixedRay | None:
        """Return the ray that it has the world carry along."""
        return None

    @classmethod
    def make_sensors(cls, fitted: Sequence[Fitted], context: SensorContext) -> "Sequence[Sensor | None]":
        """Return the sensors of all devices of this kind in a half, in order; None for what is none."""
        return [one.device.make_sensor(one, context) for one in fitted]

    def make_sensor(self, _fitted: Fitted, _context: SensorContext) -> Sensor | None:
        """Return the sensor of this device; None if it is none."""
        return None

    def make_motion(self, _fitted: Fitted, _movers: Movers) -> Motion | None:
        """Return the motion of a motor; None if it is none."""
        return None

    def describe(self) -> str:
        """Return its words on the rule sheet, with its range and its noise."""
        raise NotImplementedError
