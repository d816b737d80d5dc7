"""The file ``robot.yaml`` of a submission: the designs of a team's robots."""

from typing import Annotated, Literal

from pydantic import Field, StringConstraints

from rcj_challenges.chassis import USUAL_CHASSIS, AnyChassis
from rcj_challenges.devices import AnyDevice
from rcj_challenges.rules.fields import Name, Strict, described

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
    robots: tuple[Name, ...] = Field(
        (), strict=False, max_length=64, description="the design of robot 1, 2, …; with one design it may be left out"
    )
