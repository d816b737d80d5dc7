"""Outlines on the floor: what a body covers, seen from above, and whether two of them overlap."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import cos, hypot, sin

from rcj_challenges.scenario.models.robots import Chassis

Point = tuple[float, float]

_TOUCH_M = 1e-6
"""Bodies that overlap by less only touch: a micrometre, far under what MuJoCo's contacts resolve."""


@dataclass(frozen=True)
class Disc:
    """A round part."""

    centre: Point
    radius_m: float


Part = Disc | tuple[Point, ...]
"""A round part, or the corners of a convex one."""


@dataclass(frozen=True)
class Outline:
    """A body seen from above: the union of its parts."""

    parts: tuple[Part, ...]

    def box(self) -> tuple[float, float, float, float]:
        """Return smallest x, largest x, smallest y, largest y in m."""
        xs, ys = zip(*(corner for part in self.parts for corner in _extremes(part)), strict=True)
        return min(xs), max(xs), min(ys), max(ys)

    def overlaps(self, other: Outline) -> bool:
        """Return whether two bodies share more than their edges."""
        return any(_overlap(a, b) for a in self.parts for b in other.parts)


def _extremes(part: Part) -> Sequence[Point]:
    if not isinstance(part, Disc):
        return part
    (x, y), r = part.centre, part.radius_m
    return ((x - r, y), (x + r, y), (x, y - r), (x, y + r))


def rectangle(centre: Point, half_x_m: float, half_y_m: float, yaw_rad: float) -> tuple[Point, ...]:
    """Return the corners of a turned rectangle, counter-clockwise."""
    c, s = cos(yaw_rad), sin(yaw_rad)
    corners = ((half_x_m, half_y_m), (-half_x_m, half_y_m), (-half_x_m, -half_y_m), (half_x_m, -half_y_m))
    return tuple((centre[0] + x * c - y * s, centre[1] + x * s + y * c) for x, y in corners)


def robot_outline(chassis: Chassis, x_m: float, y_m: float, yaw_rad: float) -> Outline:
    """Return a robot's outline: the cube and, across it, both wheels (0.10 wide; reference, section 2)."""
    half = chassis.size_m / 2
    across = chassis.wheel_track_m / 2 + chassis.wheel_width_m / 2
    cube = rectangle((x_m, y_m), half, half, yaw_rad)
    return Outline((cube, rectangle((x_m, y_m), chassis.wheel_radius_m, across, yaw_rad)))


def _axes(corners: Sequence[Point]) -> list[Point]:
    found = []
    for (ax, ay), (bx, by) in zip(corners, (*corners[1:], corners[0]), strict=True):
        length = hypot(bx - ax, by - ay)
        if length:
            found.append(((by - ay) / length, (ax - bx) / length))
    return found


def _span(part: Part, axis: Point) -> tuple[float, float]:
    if isinstance(part, Disc):
        middle = part.centre[0] * axis[0] + part.centre[1] * axis[1]
        return middle - part.radius_m, middle + part.radius_m
    along = [x * axis[0] + y * axis[1] for x, y in part]
    return min(along), max(along)


def _overlap(a: Part, b: Part) -> bool:
    """Separating axes: two convex parts are apart if their shadows on one of these lines are."""
    axes = [axis for part in (a, b) if not isinstance(part, Disc) for axis in _axes(part)]
    for disc, other in ((a, b), (b, a)):
        if isinstance(disc, Disc):
            corners = [other.centre] if isinstance(other, Disc) else list(other)
            nearest = min(corners, key=lambda corner: hypot(corner[0] - disc.centre[0], corner[1] - disc.centre[1]))
            dx, dy = nearest[0] - disc.centre[0], nearest[1] - disc.centre[1]
            length = hypot(dx, dy)
            axes.append((dx / length, dy / length) if length else (1.0, 0.0))
    for axis in axes:
        (a_0, a_1), (b_0, b_1) = _span(a, axis), _span(b, axis)
        if min(a_1, b_1) - max(a_0, b_0) <= _TOUCH_M:
            return False
    return True


def is_simple(points: Sequence[Point]) -> bool:
    """Return whether a polygon has an area and no two of its edges cross or touch except at shared corners."""
    count = len(points)
    edges = [(points[i], points[(i + 1) % count]) for i in range(count)]
    if any(a == b for a, b in edges):
        return False
    area = sum(ax * by - bx * ay for (ax, ay), (bx, by) in edges)
    if abs(area) < 1e-12:
        return False
    for i, (a, b) in enumerate(edges):
        for j in range(i + 1, count):
            c, d = edges[j]
            if j == i + 1 or (i == 0 and j == count - 1):
                shared, p, q = (b, a, d) if j == i + 1 else (a, b, c)
                if side(p, shared, q) == 0 and _between(shared, p, q) is False:
                    return False  # doubles back on itself
            elif _meet(a, b, c, d):
                return False
    return True


def side(a: Point, b: Point, p: Point) -> float:
    """Return on which side of the line from a to b a point is: over 0 on the left, under 0 on the right."""
    return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])


def _between(p: Point, a: Point, b: Point) -> bool:
    """Return whether a point of the line through a and b lies between them."""
    return min(a[0], b[0]) <= p[0] <= max(a[0], b[0]) and min(a[1], b[1]) <= p[1] <= max(a[1], b[1])


def _meet(a: Point, b: Point, c: Point, d: Point) -> bool:
    sides = (side(a, b, c), side(a, b, d), side(c, d, a), side(c, d, b))
    if sides[0] * sides[1] < 0 and sides[2] * sides[3] < 0:
        return True
    on = ((c, a, b), (d, a, b), (a, c, d), (b, c, d))
    return any(at == 0 and _between(p, q, r) for at, (p, q, r) in zip(sides, on, strict=True))
