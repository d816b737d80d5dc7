"""What teams may design for their robots, and ``robot.yaml``, in which they do."""

from typing import Annotated, Literal

from pydantic import Field, StringConstraints

from rcj_challenges.chassis import USUAL_CHASSIS, AnyChassis
from rcj_challenges.chassis.base import Shape
from rcj_challenges.devices import AnyDevice
from rcj_challenges.rules.fields import DeviceName, Name, NotNegative, Positive, Strict, described

Points = Annotated[int, Field(ge=0, le=1_000_000)]


class Allowance(Strict):
    """What one field of a part may be; of a list, such as ``wheels_at_rad``, how long it may be."""

    least: float | None = described(None, "smallest value; left out: that of the field itself")
    most: float | None = described(None, "largest value; left out: the last of `prices`, or that of the field itself")
    prices: tuple[tuple[float, Points], ...] = described(
        (), "[up to this value, points], in increasing order; more is not allowed", max_length=32
    )


class Part(Strict):
    """A kind of device or drive that designs may have."""

    price: Points = described(0, "points for each")
    at_most: int | None = described(None, "how many a robot may have; left out: any number", ge=0, le=32)
    limits: dict[Name, Allowance] = described(
        {},
        "what its fields may be, and what they cost; where it sits may be chosen freely, all other fields keep their "
        "defaults",
    )


class Guideline(Strict):
    """Limits and prices for robots that teams design in the file ``robot.yaml`` of their submission."""

    budget: Points = described(..., "points that a robot may cost")
    designs: int = described(3, "how many designs a team may have", ge=1, le=8)
    max_diameter_m: Positive = described(..., "diameter in m of the cylinder that it must fit in, around its centre")
    max_height_m: Positive = described(..., "largest height in m")
    max_mass_kg: Positive = described(..., "largest mass in kg, with wheels")
    max_mouth_m: NotNegative = described(0.0, "how far in m a ball may enter between the jaws; 0: no jaws")
    shapes: tuple[Shape, ...] = described(("box", "round", "flat_front"), "shapes of the body")
    drives: dict[Name, Part] = described(..., "drives by their word: differential, omni", min_length=1)
    devices: dict[Name, Part] = described({}, "devices by their word: sonar, camera, …; others are not allowed")
    keeps: tuple[DeviceName, ...] = described((), "devices of its kit that every robot keeps, for nothing")


PlainDeviceName = Annotated[str, StringConstraints(pattern=r"^[A-Za-z0-9_][A-Za-z0-9_ .-]*$", max_length=64)]


class Design(Strict):
    """A robot that a team has designed: like a kit, a chassis and devices."""

    chassis: AnyChassis = described(USUAL_CHASSIS, "its body and wheels; without `drive` it is `differential`")
    devices: dict[PlainDeviceName, AnyDevice] = described(
        {}, "devices by name, besides those that it keeps", max_length=32
    )


class RobotFile(Strict):
    """All of ``robot.yaml``."""

    design_version: Literal[1] = described(..., "version of this format")
    designs: dict[Name, Design] = described(..., "designs by name", min_length=1, max_length=8)
    robots: tuple[Name, ...] = described(
        (), "the design of robot 1, 2, …; with one design it may be left out", max_length=64
    )
