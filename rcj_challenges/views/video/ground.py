"""The field seen from above, without anything that moves: drawn once for a whole video."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from PIL import Image, ImageDraw

from rcj_challenges.scenario.models.field import Box, Cylinder
from rcj_challenges.scenario.remembered import fixed_spots
from rcj_challenges.views.drawing.shapes import box, floor_outline, forward_mark, turned
from rcj_challenges.views.video.camera import WALL_M, ends_of_field
from rcj_challenges.views.video.colours import EDGE, GATE, GRASS, LINE, OUTSIDE, WALL, Rgb, mixed, rgb
from rcj_challenges.views.video.footage import Footage

Point = tuple[float, float]
Segment = tuple[Point, Point]

_FINER = 2
"""The ground is drawn this many times larger each way and then reduced: smooth edges."""
_STRIPES = 8
LINE_M = 0.008


@dataclass(frozen=True)
class Projection:
    """From the field to a picture of it from above.

    Pixel coordinates are continuous: pixel ``i`` reaches from ``i`` to ``i + 1``; y grows downwards.

    Attributes:
        px_per_m: scale.
        lying: True: +y of the field (blue's goal in a match) is on the left, +x is up. False: +y is up, +x right.
        at: the point of the field …
        centre: … that is shown here, in pixels.
    """

    px_per_m: float
    lying: bool
    at: Point
    centre: Point

    def px(self, x_m: float, y_m: float) -> Point:
        """Return where a point of the field is in the picture."""
        x, y = x_m - self.at[0], y_m - self.at[1]
        right, up = (-y, x) if self.lying else (x, y)
        return self.centre[0] + self.px_per_m * right, self.centre[1] - self.px_per_m * up

    def turn_rad(self, yaw_rad: float) -> float:
        """Return the direction in the picture, counter-clockwise from the right, of a yaw."""
        return yaw_rad + math.pi / 2 if self.lying else yaw_rad


def paint_ground(footage: Footage, size: tuple[int, int], view: Projection) -> Image.Image:
    """Return a picture of floor, lines, walls, goals and fixed obstacles."""
    paper = _Paper(size, view)
    field = footage.things["field"]
    w, h, cut = field["width_m"] / 2, field["length_m"] / 2, field["corner_cut_m"]
    outer = _octagon(w + WALL_M, h + WALL_M, cut)
    goals = [_goal_corners(goal, h) for goal in field["goals"]]
    for goal, (_, outside) in zip(field["goals"], goals, strict=True):
        paper.polygon(outside, mixed(rgb(goal["colour"]), EDGE, 0.15))
    paper.polygon(outer, WALL)
    inner = _octagon(w, h, cut)
    paper.striped(inner, w, h)
    for goal, (inside, _) in zip(field["goals"], goals, strict=True):
        paper.polygon(inside, mixed(rgb(goal["colour"]), EDGE, 0.45))
        paper.line([inside[0], inside[1]], LINE)
    paper.line([*inner, inner[0]], LINE)
    if goals:  # the halfway line is one between goals
        paper.line([(-w, 0.0), (w, 0.0)], LINE)
    _zones(paper, footage)
    for start, end in gate_lines(footage):
        paper.line([start, end], GATE)
    for spot in fixed_spots(footage.scenario).values():
        paper.disc((spot.x_m, spot.y_m), 0.006, LINE)
    _obstacles(paper, footage)
    return paper.finished()


def gate_lines(footage: Footage) -> list[Segment]:
    """Return the lines on the floor of gates that stand still and by which rules judge, each with its mark forward.

    As on the pages who watches must see them.
    """
    return _lines_by_anchor(footage).get(None, [])


def moving_gate_lines(footage: Footage) -> dict[int, list[Segment]]:
    """Return those of gates that move, by the entity with which they do: x ahead of its centre, y on its left, in m."""
    return {anchor: lines for anchor, lines in _lines_by_anchor(footage).items() if anchor is not None}


def _lines_by_anchor(footage: Footage) -> dict[int | None, list[Segment]]:
    found: dict[int | None, list[Segment]] = {}
    for told in footage.things["gates"]:
        if told["used"]:
            gate = footage.scenario.gates[told["name"]]
            found.setdefault(told["anchor"], []).extend(
                ((gate.from_m, gate.to_m), forward_mark(gate.from_m, gate.to_m))
            )
    return found


def _zones(paper: _Paper, footage: Footage) -> None:
    """Draw the zones that are lines on the field, up to its walls."""
    for zone in footage.scenario.zones.values():
        outline = floor_outline(zone, footage.scenario.field) if zone.drawn else []
        if outline:
            paper.line([*outline, outline[0]], rgb(zone.colour) if zone.colour else LINE)


def _obstacles(paper: _Paper, footage: Footage) -> None:
    for name, obstacle in footage.scenario.obstacles.items():
        if name in footage.roster.entities:
            continue
        colour = rgb(obstacle.colour)
        if isinstance(obstacle, Cylinder):
            paper.disc(obstacle.centre_m, obstacle.radius_m, colour)
        elif isinstance(obstacle, Box):
            paper.polygon(turned(box(*obstacle.size_m), obstacle.centre_m, obstacle.yaw_rad), colour)
        else:
            (x1, y1), (x2, y2) = obstacle.from_m, obstacle.to_m
            shape = box(math.hypot(x2 - x1, y2 - y1), obstacle.thickness_m)
            middle = ((x1 + x2) / 2, (y1 + y2) / 2)
            paper.polygon(turned(shape, middle, math.atan2(y2 - y1, x2 - x1)), colour)


def whole_field(footage: Footage, size: tuple[int, int], top: int) -> Projection:
    """Return the projection that shows all of the field below a margin at the top, as large as fits.

    The long side lies in a picture that is wider than tall, and stands in one that is taller than wide.
    """
    width, height = size[0], size[1] - top
    across, along = ends_of_field(footage)
    lying = (width >= height) == (along >= across)
    right, up = (along, across) if lying else (across, along)
    scale = min(width / (2 * right), height / (2 * up)) * 0.97
    return Projection(scale, lying, (0.0, 0.0), (width / 2, top + height / 2))


class _Paper:
    """A finer picture in the field's coordinates."""

    def __init__(self, size: tuple[int, int], view: Projection) -> None:
        self._view = view
        self._image = Image.new("RGB", (size[0] * _FINER, size[1] * _FINER), OUTSIDE)
        self._pen = ImageDraw.Draw(self._image)

    def polygon(self, corners: Sequence[Point], colour: Rgb) -> None:
        self._pen.polygon(self._finer(corners), fill=colour)

    def striped(self, corners: Sequence[Point], w: float, h: float) -> None:
        """Fill an outline with mown grass: stripes across the field."""
        mask = Image.new("1", self._image.size)
        ImageDraw.Draw(mask).polygon(self._finer(corners), fill=1)
        grass = Image.new("RGB", self._image.size, GRASS[0])
        pen = ImageDraw.Draw(grass)
        for stripe in range(1, _STRIPES, 2):
            low, high = (-h + 2 * h * k / _STRIPES for k in (stripe, stripe + 1))
            pen.polygon(self._finer([(-w, low), (w, low), (w, high), (-w, high)]), fill=GRASS[1])
        self._image.paste(grass, (0, 0), mask)

    def line(self, corners: Sequence[Point], colour: Rgb) -> None:
        width = max(_FINER, round(LINE_M * self._view.px_per_m * _FINER))
        self._pen.line(self._finer(corners), fill=colour, width=width, joint="curve")

    def disc(self, centre: Point, radius_m: float, colour: Rgb) -> None:
        ((x, y),) = self._finer([centre])
        self._pen.circle((x, y), radius_m * self._view.px_per_m * _FINER, fill=colour)

    def finished(self) -> Image.Image:
        return self._image.reduce(_FINER)

    def _finer(self, points: Sequence[Point]) -> list[Point]:
        found = (self._view.px(*point) for point in points)
        return [(x * _FINER, y * _FINER) for x, y in found]


def _octagon(w: float, h: float, cut: float) -> list[Point]:
    return [(w - cut, h), (w, h - cut), (w, -h + cut), (w - cut, -h),
            (-w + cut, -h), (-w, -h + cut), (-w, h - cut), (-w + cut, h)]  # fmt: skip


def _goal_corners(goal: dict[str, object], h: float) -> tuple[list[Point], list[Point]]:
    """Return inside and outside of a goal's walls; the first two corners are its posts."""
    sign = 1 if goal["end"] == "positive_y" else -1
    half, depth = float(str(goal["width_m"])) / 2, float(str(goal["depth_m"]))

    def corners(more: float) -> list[Point]:
        far = sign * (h + depth + more)
        return [(-half - more, sign * h), (half + more, sign * h), (half + more, far), (-half - more, far)]

    return corners(0.0), corners(WALL_M)
