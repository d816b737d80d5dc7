"""Sections ``kits``, ``robots`` and ``entrants``: the machines, their devices, and who drives them."""

from typing import Annotated, Literal

from pydantic import Field, StringConstraints

from rcj_challenges.rules.fields import DeviceName, Name, NotNegative, OneOrMinusOne, Point, Positive, Strict, described
from rcj_challenges.rules.refs import ONE_ROBOT, Ref, SectionRef


class Chassis(Strict):
    """The body: a cube on two wheels. The defaults are those of the original's robots."""

    # Their source: reference, section 2.

    size_m: Positive = described(0.075, "edge of the cube in m", le=0.5)
    mass_kg: Positive = described(0.2, "mass of the cube in kg", le=20)
    wheel_radius_m: Positive = described(0.02, "radius of the wheels in m", le=0.2)
    wheel_width_m: Positive = described(0.01, "width of the wheels in m", le=0.1)
    wheel_track_m: Positive = described(0.09, "between the wheels' centres in m", le=0.6)
    wheel_mass_kg: Positive = described(0.005, "mass of each wheel in kg", le=1)
    max_wheel_radps: Positive = described(10.0, "highest wheel speed in rad/s; faster commands are clamped", le=100)


class MotorDevice(Strict):
    """A wheel's motor."""

    device: Literal["motor"]
    wheel: Literal["left", "right"] = described(..., "the wheel it turns; left is +y of the robot that looks along +x")
    direction: OneOrMinusOne = described(1, "1: positive velocity drives the robot along its +x; -1: along -x")


class WheelSensorDevice(Strict):
    """The turning angle of a wheel in rad."""

    device: Literal["wheel_sensor"]
    wheel: Literal["left", "right"] = described(..., "the wheel it measures; left is +y of the robot")
    direction: OneOrMinusOne = described(1, "1: grows while the robot drives along its +x; -1: falls")


class GpsDevice(Strict):
    """The position of the cube's centre."""

    device: Literal["gps"]
    frame: Literal["field", "legacy"] = described("field", "field: [x, y, z]; legacy: [y, z, x] as in the 2021 worlds")
    noise_m: NotNegative = described(0.0, "standard deviation of each coordinate in m")


class CompassDevice(Strict):
    """The direction of north."""

    device: Literal["compass"]
    frame: Literal["field", "legacy"] = described("field", "field: [sin ψ, cos ψ, 0]; legacy: [cos θ, 0, sin θ]")
    noise_rad: NotNegative = described(0.0, "standard deviation of the heading in rad")


SONAR_NOISE_FULL_FROM_M = 1.0
"""Up to here the share of a sonar's noise grows with the distance. Source: reference, 4.1."""


class SonarDevice(Strict):
    """A distance sensor: one horizontal ray. The defaults are those of the original's robots."""

    # Their source: reference, section 4.1.

    device: Literal["sonar"]
    bearing_rad: float = described(..., "direction in the robot's frame in rad; 0 front, 1.5708 left (+y)")
    offset_m: NotNegative = described(0.0385, "where the ray starts, from the centre along the bearing, in m")
    height_m: Positive = described(0.0575, "height of the ray above the floor in m")
    range_m: Positive = described(1.0, "beyond it the out-of-range value is read, in m", le=20)
    noise: NotNegative = described(0.05, "standard deviation as a share of the value, times the distance up to 1 m")
    lost_from_rad: Positive = described(0.3927, "from this angle to the surface's normal on, no echo comes back, rad")


class BallReceiverDevice(Strict):
    """The infra-red receiver that hears the ball: strength and direction of each packet."""

    device: Literal["ball_receiver"]
    channel: int = described(4, "channel number that getChannel returns")
    range_m: Positive = described(0.6, "3-D distance between ball's and robot's centres up to which it hears, in m")
    strength_noise: NotNegative = described(0.0, "standard deviation of the strength as a share of it")
    direction_noise_rad: NotNegative = described(0.0, "standard deviation of the direction's bearing in rad")


class SupervisorReceiverDevice(Strict):
    """The receiver of the referee's packets, one a tick or as often as the kit says."""

    device: Literal["supervisor_receiver"]
    channel: int = described(1, "channel number that getChannel returns")


class TeamReceiverDevice(Strict):
    """The receiver of the own team's radio. Its channel is that of the team."""

    device: Literal["team_receiver"]
    range_m: Positive = described(10.0, "how far away it hears, in m; of it and the emitter the shorter range counts")


class TeamEmitterDevice(Strict):
    """The emitter of the own team's radio."""

    device: Literal["team_emitter"]
    range_m: Positive = described(
        10.0, "how far away it is heard, in m; of it and the receiver the shorter range counts"
    )
    baud: int = described(115_200, "speed in bits per second; 8 bits a byte, so 460.8 bytes a tick by default", gt=0)


class LidarDevice(Strict):
    """A laser scanner of one layer. The defaults are those of the original's robots."""

    # Their source: reference, section 4.2.

    device: Literal["lidar"]
    points: int = described(360, "how many readings there are, evenly over field_of_view_rad", ge=1, le=1440)
    field_of_view_rad: Positive = described(6.283185307179586, "angle covered by the readings in rad", le=6.2832)
    min_range_m: NotNegative = described(0.01, "nearer things read as inf, in m")
    max_range_m: Positive = described(3.0, "farther things read as inf, in m", le=50)
    frame: Literal["field", "legacy"] = described(
        "field", "of its points; field: x ahead, y left, z up; legacy: x left, y up, z ahead as in the 2021 worlds"
    )
    height_m: Positive = described(0.0425, "height of the scanning plane above the floor in m")
    rotating: bool = described(True, "True: a turning head refreshes part of the readings each tick; False: all")
    frequency_hz: Positive = described(10.0, "turns per second of a rotating head", le=31)
    noise_m: NotNegative = described(0.0, "standard deviation of each reading in m")


Device = Annotated[
    MotorDevice
    | WheelSensorDevice
    | GpsDevice
    | CompassDevice
    | SonarDevice
    | BallReceiverDevice
    | SupervisorReceiverDevice
    | TeamReceiverDevice
    | TeamEmitterDevice
    | LidarDevice,
    Field(discriminator="device"),
]


class Kit(Strict):
    """A robot as it can be bought: chassis, frame, messages and devices. Presets bring ``v2`` and ``legacy_2021``."""

    messages: Literal["v2.1", "v2.2", "2021"] = described(
        "v2.1", "what the referee's packets look like: one byte, JSON text, or the 2021 struct of positions"
    )
    packet_every_ticks: int = described(1, "the referee sends a packet every this many ticks", ge=1, le=1000)
    packet_lists: Annotated[tuple[Name, ...], ONE_ROBOT] = Field(
        (), strict=False, description="robots whose positions a 2021 packet lists, in order"
    )
    packet_has_flag: bool = described(True, "whether a 2021 packet ends with waiting_for_kickoff (the first demo: no)")
    control_step_ms: int = described(
        32,
        "the step that programs of this kit usually take, in ms, for the rule sheet; each takes the step it asks for",
        ge=1,
    )
    looks_along: Literal["+x", "-x"] = described(
        "+x", "which end is shown as the front in pictures and views; yaw, devices and rules go by +x in any case"
    )
    chassis: Chassis = described(Chassis(), "the body")
    devices: dict[DeviceName, Device] = described({}, "devices by the name that programs ask for")


class StartPose(Strict):
    """Where a robot stands at the start of a half, and where ``at: start`` puts it back."""

    x_m: float = described(..., "x in m")
    y_m: float = described(..., "y in m")
    yaw_rad: float = described(..., "yaw in rad, counter-clockwise from +x; 1.57 faces +y")
    noise_m: Annotated[Point, Field(description="half width of uniform noise on x and y, in m, 0 to 5")] = (0.0, 0.0)


class Robot(Strict):
    """One robot: its colour, its kit, where it starts, and how its devices differ from the kit."""

    colour: Name = described(..., "its team colour, a CSS colour name; also a group of its robots: blue, yellow")
    number: int = described(..., "number on its lid", ge=0, le=99)
    kit: Annotated[Name, SectionRef("kit", ("kits",))] = described(..., "name of its kit")
    start: StartPose = described(..., "where it starts")
    devices: dict[DeviceName, Device] = described(
        {}, "devices added to those of its kit, or changed: one without 'device' is as in the kit but for what it says"
    )
    without: tuple[DeviceName, ...] = Field((), strict=False, description="devices of the kit that it lacks")
    idle: bool = described(False, "True: no program drives it, its wheels are braked (an obstacle)")


EntryPoint = Annotated[str, StringConstraints(pattern=r"^[A-Za-z0-9_][A-Za-z0-9_./-]*\.py$", max_length=200)]
EntryPoints = EntryPoint | Annotated[tuple[EntryPoint, ...], Field(strict=False, min_length=1)]


class Entrant(Strict):
    """Who competes: which robots its programs drive. ``check`` demands these entry points of a ZIP."""

    robots: Annotated[dict[Name, EntryPoints], Ref("robot", frozenset({"robot"}), keys=True)] = described(
        ..., "entry point by robot: a path inside the submission, or several of which the first that exists is taken"
    )
    radio_channel: int = described(
        2, "team radio channel of all robots that it drives, whatever their colour", ge=1, le=1000
    )
    title: str = described("", "what the seat is called on screen when no team name is given", max_length=64)
