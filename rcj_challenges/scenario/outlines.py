"""Outlines of bodies seen from above: what overlaps what, and how large the gap is.

An outline is a union of convex parts; a part is a convex polygon, or a single point, with a radius around it. A robot
is the footprint of its chassis, a ball a point with its radius. Only what is checked before a
match, and placements, are judged with it, so clarity comes before speed.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import inf, sqrt

from rcj_challenges.core.amounts import add_up
from rcj_challenges.core.play import Pose2
from rcj_challenges.geometry.polygons import Point, box, distance_to_segment_m, side, turned
from rcj_challenges.scenario.kits import chassis_of
from rcj_challenges.scenario.models.field import Ball, Box, Cylinder, FieldModel, Wall
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.shapes import floor_of, goal_floor

Points = tuple[Point, ...]

TOUCHING_M = 1e-6
"""Bodies that touch do not overlap; float32 poses put them up to this much into each other."""


@dataclass(frozen=True, slots=True)
class Part:
    """A convex piece of an outline: a polygon (or one point), widened by a radius. Metres."""

    points: Points
    radius_m: float = 0.0

    def at(self, pose: Pose2) -> Part:
        """Return the part of a body that stands at a pose."""
        return Part(turned(self.points, pose), self.radius_m)


@dataclass(frozen=True, slots=True)
class Outline:
    """A body seen from above, in its own frame: the union of convex parts.

    Attributes:
        reach_m: radius of a circle around its origin that holds it all.
    """

    parts: tuple[Part, ...]
    reach_m: float

    @classmethod
    def of(cls, *parts: Part) -> Outline:
        """Return the outline made of the parts."""
        reach = max(sqrt(px * px + py * py) + part.radius_m for part in parts for px, py in part.points)
        return cls(parts, reach)

    def at(self, pose: Pose2) -> tuple[Part, ...]:
        """Return its parts where it stands."""
        return tuple(part.at(pose) for part in self.parts)


def counter_clockwise(points: Points) -> Points:
    """Return the corners of a polygon so that they run counter-clockwise."""
    pairs = zip(points, (*points[1:], points[0]), strict=True)
    return points if add_up(ax * by - ay * bx for (ax, ay), (bx, by) in pairs) >= 0.0 else points[::-1]


def disc(radius_m: float) -> Outline:
    """Return the outline of a ball or a cylinder."""
    return Outline.of(Part(((0.0, 0.0),), radius_m))


def outline_of(scenario: Scenario, name: str) -> Outline:
    """Return the outline of a robot, with its wheels, of a ball or of an obstacle."""
    if name in scenario.robots:
        return Outline.of(*map(Part, chassis_of(scenario, name).footprint()))
    match scenario.balls.get(name) or scenario.obstacles[name]:
        case Wall(from_m=(ax, ay), to_m=(bx, by), thickness_m=thickness_m):
            return Outline.of(Part(box(sqrt((bx - ax) ** 2 + (by - ay) ** 2), thickness_m)))
        case Box(size_m=size_m):
            return Outline.of(Part(box(*size_m)))
        case Ball(radius_m=radius_m) | Cylinder(radius_m=radius_m):
            return disc(radius_m)


def extent(parts: Iterable[Part]) -> tuple[float, float, float, float]:
    """Return smallest x, largest x, smallest y, largest y of a body in m."""
    extremes = [
        (x - part.radius_m, x + part.radius_m, y - part.radius_m, y + part.radius_m)
        for part in parts
        for x, y in part.points
    ]
    west, east, south, north = zip(*extremes, strict=True)
    return min(west), max(east), min(south), max(north)


def overlap(first: Iterable[Part], second: Iterable[Part]) -> bool:
    """Return whether two bodies share more than their edges."""
    others = tuple(second)
    return any(closer_than(a, b, -TOUCHING_M) for a in first for b in others)


def gap_m(first: Part, second: Part) -> float:
    """Return the gap between two parts in m; negative if they overlap (then only its sign means anything)."""
    radii = first.radius_m + second.radius_m
    apart = apart_m(first.points, second.points)
    if apart < 0.0:
        return apart - radii
    return min(_nearest(first.points, second.points), _nearest(second.points, first.points)) - radii


def closer_than(first: Part, second: Part, limit_m: float) -> bool:
    """Return whether the gap between two parts is smaller than a limit in m, looking closely only where needed."""
    apart = apart_m(first.points, second.points)
    radii = first.radius_m + second.radius_m
    if apart - radii >= limit_m:
        return False
    if radii == 0.0 and limit_m <= 0.0:  # whether polygons overlap is all that is asked, and that is known
        return True
    return gap_m(first, second) < limit_m


def apart_m(first: Points, second: Points) -> float:
    """Return a lower bound of the distance of two point sets; negative just if they overlap."""
    if len(first) == 1 and len(second) == 1:
        return sqrt((first[0][0] - second[0][0]) ** 2 + (first[0][1] - second[0][1]) ** 2)
    bound = -inf
    if len(first) > 1:
        bound = _apart_along_normals(first, second)
    if len(second) > 1:
        bound = max(bound, _apart_along_normals(second, first))
    return bound


def _apart_along_normals(polygon: Points, other: Points) -> float:
    """Return the largest gap along a normal of the polygon's edges (separating axes); negative: none separates.

    The polygon's corners run counter-clockwise, as `counter_clockwise` makes them.
    """
    best = -inf
    ax, ay = polygon[-1]
    for bx, by in polygon:
        nx, ny = by - ay, ax - bx
        length = sqrt(nx * nx + ny * ny)
        if length > 0.0:
            nearest = min([nx * x + ny * y for x, y in other])
            best = max(best, (nearest - nx * ax - ny * ay) / length)
        ax, ay = bx, by
    return best


def _nearest(corners: Points, polygon: Points) -> float:
    edges = tuple(zip(polygon, (*polygon[1:], polygon[0]), strict=True))
    return min(distance_to_segment_m(x, y, *a, *b) for x, y in corners for a, b in edges)


# --- the floor --------------------------------------------------------------------------------------------------------

# Walls are solid far beyond their real thickness here, as nothing can stand in or behind them. What is placed outside
# the box around field and goals is refused before any wall is looked at, however far out it is.
_SOLID_M = 10.0


def _solid_walls(field: FieldModel) -> tuple[Part, ...]:
    """Return everything solid around the floor: side and end walls, corner walls, goals."""
    x, y, far = field.bounds.width_m / 2, field.bounds.length_m / 2, _SOLID_M
    parts = [_box(x, x + far, -y - far, y + far), _box(-x - far, -x, -y - far, y + far)]
    for end, sign in (("positive_y", 1.0), ("negative_y", -1.0)):
        goals = [goal for goal in field.goals.values() if goal.end == end]
        half = max((goal.width_m / 2 for goal in goals), default=0.0)
        depth = max((goal.depth_m for goal in goals), default=0.0)
        low, high = sorted((sign * y, sign * (y + far)))
        parts += [_box(half, x + far, low, high), _box(-x - far, -half, low, high)]
        back_low, back_high = sorted((sign * (y + depth), sign * (y + far)))
        parts.append(_box(-half, half, back_low, back_high) if goals else _box(-x, x, low, high))
    cut = field.cut_m
    if cut > 0:
        parts += [
            Part(counter_clockwise(((sx * (x - cut), sy * y), (sx * x, sy * (y - cut)), (sx * x, sy * y))))
            for sx in (1, -1)
            for sy in (1, -1)
        ]
    return tuple(parts)


def _box(x_min: float, x_max: float, y_min: float, y_max: float) -> Part:
    return Part(((x_max, y_max), (x_min, y_max), (x_min, y_min), (x_max, y_min)))


class Floor:
    """Where a body may stand: the field between its walls, and the goals."""

    def __init__(self, field: FieldModel) -> None:
        # With where they reach from and to, so that few have to be looked at closely.
        self._walls = [(*extent([wall]), wall) for wall in _solid_walls(field)]
        self._reach_m = field.bounds.reach_m
        outlines = (floor_of(field.bounds), *(goal_floor(goal, field) for goal in field.goals.values()))
        self._parts = [counter_clockwise(tuple(outline)) for outline in outlines]  # all are convex

    def has(self, point: Point) -> bool:
        """Return whether a point is on the floor, or on its edge."""
        return any(
            all(side(a, b, point) >= 0 for a, b in zip(part, (*part[1:], part[0]), strict=True)) for part in self._parts
        )

    def holds(self, parts: Sequence[Part]) -> bool:
        """Return whether a body stands on the floor without being in a wall."""
        x_0, x_1, y_0, y_1 = extent(parts)
        if abs(x_0 + x_1) / 2 > self._reach_m[0] or abs(y_0 + y_1) / 2 > self._reach_m[1]:
            return False
        near = (
            wall
            for west, east, south, north, wall in self._walls
            if west < x_1 and x_0 < east and south < y_1 and y_0 < north
        )
        return not any(closer_than(part, wall, -TOUCHING_M) for wall in near for part in parts)
