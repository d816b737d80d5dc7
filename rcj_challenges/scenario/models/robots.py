"""Sections ``kits``, ``robots`` and ``entrants``: the machines, their devices, and who drives them."""

from dataclasses import replace
from typing import Annotated, Literal

from pydantic import Field, StringConstraints

from rcj_challenges.chassis import USUAL_CHASSIS, AnyChassis
from rcj_challenges.devices import AnyDevice
from rcj_challenges.rules.fields import DeviceName, Name, Point, Strict, described
from rcj_challenges.rules.refs import ONE_ROBOT, SectionRef


class Kit(Strict):
    """A robot kit: chassis, messages and devices. The presets define ``v2`` and ``legacy_2021``."""

    messages: Literal["v2.1", "v2.2", "2021"] = described(
        "v2.1", "format of the referee's packets: one byte (v2.1), JSON text (v2.2), or the 2021 struct of positions"
    )
    packet_every_ticks: int = described(1, "number of ticks from one referee packet to the next", ge=1, le=1000)
    packet_lists: Annotated[tuple[Name, ...], ONE_ROBOT] = described(
        (), "robots whose positions a 2021 packet lists, in order"
    )
    packet_has_flag: bool = described(
        True, "whether 2021 packets end with waiting_for_kickoff (those of the first demo did not)"
    )
    control_step_ms: int = described(
        32,
        "usual control step of programs for this kit in ms, printed on the rule sheet; programs may use others",
        ge=1,
    )
    looks_along: Literal["+x", "-x"] = described(
        "+x", "end shown as the front in pictures and views; yaw, devices and rules always use +x"
    )
    chassis: AnyChassis = described(USUAL_CHASSIS, "its body and wheels; without `drive` it is `differential`")
    devices: dict[DeviceName, AnyDevice] = described({}, "devices by the name that programs pass to getDevice")


class StartPose(Strict):
    """Where a robot stands at the start of a half, and where ``at: start`` puts it back."""

    x_m: float = described(..., "x in m")
    y_m: float = described(..., "y in m")
    yaw_rad: float = described(..., "yaw in rad, counter-clockwise from +x; 1.57 faces +y")
    noise_m: Annotated[
        Point, Field(description="half-widths of the uniform noise added to x and y, in m, each from 0 to 5")
    ] = (0.0, 0.0)


class Robot(Strict):
    """One robot: its colour, its kit, where it starts, and how its devices differ from those of the kit."""

    colour: Name = described(
        ..., "its team colour, a CSS colour name such as blue; also the name of the group of all robots of that colour"
    )
    number: int = described(..., "number on its lid", ge=0, le=99)
    kit: Annotated[Name, SectionRef("kit", ("kits",))] = described(..., "name of its kit")
    start: StartPose = described(..., "where it starts")
    devices: dict[DeviceName, AnyDevice] = described(
        {}, "devices to add to those of its kit, or to change: an entry without `device` changes only the given keys"
    )
    without: tuple[DeviceName, ...] = described((), "devices of the kit that this robot lacks")
    idle: bool = described(False, "True: no program drives it and its wheels are braked, so it is an obstacle")


# No part of the path is empty, or one or two dots.
_PART = r"[A-Za-z0-9_.-]*[A-Za-z0-9_-][A-Za-z0-9_.-]*"
EntryPoint = Annotated[str, StringConstraints(pattern=rf"^[A-Za-z0-9_][A-Za-z0-9_.-]*(/{_PART})*\.py$", max_length=200)]
EntryPoints = EntryPoint | Annotated[tuple[EntryPoint, ...], Field(min_length=1)]


class Entrant(Strict):
    """A competitor and the robots that its programs drive. ``check`` requires a ZIP to contain these programs."""

    robots: Annotated[dict[Name, EntryPoints], replace(ONE_ROBOT, keys=True)] = described(
        ...,
        "program for each robot: a path inside the submission, or a list of paths, of which the "
        "first that exists is used",
    )
    radio_channel: int = described(
        2, "team radio channel of all robots that it drives, whatever their colour", ge=1, le=1000
    )
    design: Annotated[Name | None, SectionRef("guideline", ("guidelines",))] = described(
        None,
        "guideline for the robots of the team that starts in this seat; a submission without robot.yaml has the "
        "robots' own kits; left out: no robot.yaml counts",
    )
    kits: Annotated[tuple[Name, ...], SectionRef("kit", ("kits",))] = described(
        (),
        "kits of the team that starts in this seat, in the order of `robots`: they stay with it when sides "
        "change; left out: the robots' own",
    )
    title: str = described("", "name shown for the seat if no team name is given", max_length=64)
