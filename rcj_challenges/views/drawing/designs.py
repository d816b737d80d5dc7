"""The designs of a team as a picture: each from above, in the cylinder it must fit in, and what it costs."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from rcj_challenges.chassis.base import Chassis, WheelName, wheel_words
from rcj_challenges.core.play import Pose2
from rcj_challenges.devices.base import Device
from rcj_challenges.geometry.polygons import Point, turned
from rcj_challenges.rules.phrasing import listed, metres, metres_alike
from rcj_challenges.scenario.designs import Verdict
from rcj_challenges.scenario.models.designs import Design, Guideline
from rcj_challenges.views.drawing.paper import Entry, Paper

_ROW_PX = 400.0
_BEYOND_M = 0.025  # the paper reaches so far outside of the cylinder
_EDGE_M = 0.004  # views end so far inside of it
_AHEAD_RAD = math.pi / 2  # the front is at the top
_STEP_RAD = math.radians(6)
_ROUNDING_M = 1e-9
_MARKER = "#0b7285"
_CYLINDER = 'fill="none" stroke="{}" stroke-width="1.5" stroke-dasharray="6 4"'
_FITS, _TOO_WIDE = "#495057", "#c92a2a"
_LOOKS = 'fill="#0b7285" fill-opacity="0.12" stroke="#0b7285" stroke-opacity="0.6"'
_BODY = 'fill="#ced4da" stroke="#212529"'
_DARK = 'fill="#212529"'


def draw_designs(team: str, verdict: Verdict) -> str:
    """Return the drawing as an SVG document: a row for each design, and on the right what is in it, with prices.

    Args:
        team: its name.
        verdict: on the file; a design that breaks the guidelines is drawn too.
    """
    paper = _paper([design.chassis for design in verdict.designs.values()], verdict.guideline)
    sections = [
        (f"{name}{_robots(verdict, name)}: {points_words(verdict, name)}", _draw(paper, verdict, name, row))
        for row, name in enumerate(verdict.designs)
    ]
    sections.append(("Not as the guidelines demand", [Entry(problem.message) for problem in verdict.problems]))
    return paper.svg(f"Robots of {team}", sections, shown="designs")


def design_card(verdict: Verdict, name: str) -> tuple[str, list[Entry]]:
    """Return one design of a verdict as an SVG document, and what is in it; markers have the numbers of their lines."""
    paper = _paper([verdict.designs[name].chassis], verdict.guideline)
    lines = _draw(paper, verdict, name, 0)
    return paper.svg(name, shown="design"), lines


def points_words(verdict: Verdict, name: str) -> str:
    """Return what a design costs: ``2800 of 3000 points``."""
    return f"{sum(one.points for one in verdict.prices(name))} of {verdict.guideline.budget} points"  # integers


def _robots(verdict: Verdict, name: str) -> str:
    robots = [str(number) for number, its in enumerate(verdict.robots, 1) if its == name]
    return f" (robot{'s' * (len(robots) > 1)} {listed(robots, 'and')})" if robots else ""


def _paper(chassis: Sequence[Chassis], guideline: Guideline) -> Paper:
    far_m = max([guideline.max_diameter_m / 2, *map(_reach_m, chassis)]) + _BEYOND_M
    return Paper((-far_m, (1 - 2 * len(chassis)) * far_m, far_m, far_m), _ROW_PX / (2 * far_m))


def _draw(paper: Paper, verdict: Verdict, name: str, row: int) -> list[Entry]:
    """Draw a design in its row, and return its lines of the legend."""
    design, far_m = verdict.designs[name], paper.bounds[2]
    at = (0.0, -2 * row * far_m, _AHEAD_RAD)
    paper.text_px(10, row * _ROW_PX + 22, name, "head")
    for device_name, device in design.devices.items():  # below the body
        _draw_view(paper, device, device_name, at)
    drive = design.chassis.name()
    prices = [Entry(f"{drive} drive, {one.points}") for one in verdict.prices(name) if one.what == drive]
    return [
        *_chassis(paper, design.chassis, verdict.guideline, at),
        *prices,
        *_devices(paper, design, verdict.costs(name), at),
    ]


def _reach_m(chassis: Chassis) -> float:
    return max(math.hypot(*corner) for outline in chassis.footprint() for corner in outline)


def _chassis(paper: Paper, chassis: Chassis, guideline: Guideline, at: Pose2) -> list[Entry]:
    reach_m, limit_m = _reach_m(chassis), guideline.max_diameter_m / 2
    cylinder = _CYLINDER.format(_FITS if reach_m <= limit_m + _ROUNDING_M else _TOO_WIDE)
    for part, outline in reversed(chassis.solids().items()):
        paper.polygon(turned(outline, at), _BODY if part == "body" else _DARK, part.replace("_", " "))
    tip_m = chassis.front_m
    nose = [(tip_m * 0.95, 0.0), (tip_m * 0.8, tip_m * 0.12), (tip_m * 0.8, -tip_m * 0.12)]
    paper.polygon(turned(nose, at), _DARK, "its front")
    for wheel in chassis.wheels():
        paper.polygon(turned(wheel.corners(), at), _DARK, wheel_words(wheel.name))
    paper.circle(at[:2], limit_m, cylinder, f"the cylinder of {metres(guideline.max_diameter_m)}")
    width, cylinder_width = metres_alike((round(2 * reach_m, 4), guideline.max_diameter_m))
    return [
        Entry(chassis.body_words().rstrip(",")),
        Entry(f"needs a cylinder of {width}; {cylinder_width} allowed", sample=cylinder),
        Entry(f"weighs {chassis.total_mass_kg:.3g} kg; {guideline.max_mass_kg:g} kg allowed"),
    ]


def _devices(paper: Paper, design: Design, costs: dict[str, int], at: Pose2) -> Iterator[Entry]:
    """Draw the devices where they sit, and what they look at; those that may sit anywhere are only in the legend."""
    wheels: dict[WheelName, Point] = {wheel.name: (wheel.x_m, wheel.y_m) for wheel in design.chassis.wheels()}
    for name, device in design.devices.items():
        wheel: WheelName | None = getattr(device, "wheel", None)
        sits = device.place()
        place = sits[:2] if sits is not None else None if wheel is None else wheels.get(wheel)
        number = "" if place is None else paper.new_number()
        if place is not None:
            (spot,) = turned([place], at)
            paper.mark(spot, number, name, _MARKER)
        kind = device.name().replace("_", " ") + ("" if wheel is None else f" of {wheel_words(wheel)}")
        points = f", {costs[name]}" if costs.get(name) else ""
        yield Entry(f"{name}: {kind}{points}" if name != kind else f"{name}{points}", number, _MARKER)


def _draw_view(paper: Paper, device: Device, name: str, at: Pose2) -> None:
    view = device.looks()
    if view is None:
        return
    bearing_rad, angle_rad = view
    ahead_m, left_m, _ = device.place() or (0.0, 0.0, 0.0)
    length_m = max(paper.bounds[2] - _EDGE_M - math.hypot(ahead_m, left_m), _EDGE_M)
    steps = max(1, round(angle_rad / _STEP_RAD))
    angles = [bearing_rad + angle_rad * (step / steps - 0.5) for step in range(steps + 1)]
    rim = [(ahead_m + length_m * math.cos(angle), left_m + length_m * math.sin(angle)) for angle in angles]
    apex = [(ahead_m, left_m)] if angle_rad < math.tau - _STEP_RAD else []
    paper.polygon(turned([*apex, *rim], at), _LOOKS, f"what {name} looks at")
