"""Points, segments and polygons on the floor."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import cos, sin, sqrt

from rcj_challenges.core.amounts import add_up

Point = tuple[float, float]


def box(length_m: float, width_m: float) -> tuple[Point, ...]:
    """Return the corners of a rectangle around the origin, counter-clockwise: length along x, width along y."""
    x, y = length_m / 2, width_m / 2
    return (x, y), (-x, y), (-x, -y), (x, -y)


def turned(points: Iterable[Point], pose: tuple[float, float, float]) -> tuple[Point, ...]:
    """Return points in the frame of a body, x ahead, as points of the field."""
    at_x, at_y, yaw = pose
    c, s = cos(yaw), sin(yaw)
    return tuple((at_x + c * x - s * y, at_y + s * x + c * y) for x, y in points)


def distance_to_segment_m(x_m: float, y_m: float, ax: float, ay: float, bx: float, by: float) -> float:
    """Return the distance from a point to the segment from a to b, in m."""
    dx, dy = bx - ax, by - ay
    squared = dx * dx + dy * dy
    share = 0.0 if squared == 0.0 else max(0.0, min(1.0, ((x_m - ax) * dx + (y_m - ay) * dy) / squared))
    ex, ey = x_m - ax - share * dx, y_m - ay - share * dy
    return sqrt(ex * ex + ey * ey)


def is_simple(points: Sequence[Point]) -> bool:
    """Return whether a polygon has an area and no two of its edges cross or touch except at shared corners."""
    count = len(points)
    edges = [(points[i], points[(i + 1) % count]) for i in range(count)]
    if any(a == b for a, b in edges):
        return False
    area = add_up(ax * by - bx * ay for (ax, ay), (bx, by) in edges)
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
