"""Outlines of bodies seen from above: what overlaps what, and how large the gap is.

An outline is a union of convex parts; a part is a convex polygon, or a single point, with a radius around it. A robot
is its cube and the box around both wheels (0.10 wide), a ball a point with its radius. Only placements are judged
with it, so clarity comes before speed.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, inf, sin, sqrt

from rcj_challenges.facts.play import Pose2
from rcj_challenges.referee.regions import distance_to_segment_m
from rcj_challenges.scenario.models.field import Box, Cylinder, FieldModel, Obstacle, Wall
from rcj_challenges.scenario.models.robots import Chassis
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.starting import start_pose

Points = tuple[tuple[float, float], ...]

# Walls are solid far beyond their real thickness here, as nothing can stand in or behind them. What is placed outside
# the box around field and goals is refused before any wall is looked at, however far out it is.
_SOLID_M = 10.0
# Bodies that touch do not overlap; float32 poses put them up to this much into each other.
_TOUCHING_M = 1e-6


@dataclass(frozen=True, slots=True)
class Part:
    """A convex piece of an outline: a polygon (or one point), widened by a radius. Metres."""

    points: Points
    radius_m: float = 0.0

    def at(self, pose: Pose2) -> Part:
        """Return the part of a body that stands at a pose."""
        x, y, yaw = pose
        c, s = cos(yaw), sin(yaw)
        return Part(tuple((x + c * px - s * py, y + s * px + c * py) for px, py in self.points), self.radius_m)


@dataclass(frozen=True, slots=True)
class Outline:
    """A body seen from above, in its own frame.

    Attributes:
        parts: the convex parts whose union it is.
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


def rectangle(length_m: float, width_m: float) -> Part:
    """Return a rectangle around the origin: length along x, width along y."""
    x, y = length_m / 2, width_m / 2
    return Part(((x, y), (-x, y), (-x, -y), (x, -y)))


def counter_clockwise(points: Points) -> Points:
    """Return the corners of a polygon so that they run counter-clockwise."""
    pairs = zip(points, (*points[1:], points[0]), strict=True)
    return points if sum(ax * by - ay * bx for (ax, ay), (bx, by) in pairs) >= 0.0 else points[::-1]


def robot_outline(chassis: Chassis) -> Outline:
    """Return a robot's outline: the cube, and the box that both wheels reach."""
    wheels = rectangle(2 * chassis.wheel_radius_m, chassis.wheel_track_m + chassis.wheel_width_m)
    return Outline.of(rectangle(chassis.size_m, chassis.size_m), wheels)


def disc(radius_m: float) -> Outline:
    """Return the outline of a ball or a cylinder."""
    return Outline.of(Part(((0.0, 0.0),), radius_m))


def obstacle_outline(obstacle: Obstacle) -> Outline:
    """Return an obstacle's outline, in the frame of where it stands at the start."""
    match obstacle:
        case Cylinder():
            return disc(obstacle.radius_m)
        case Box():
            return Outline.of(rectangle(*obstacle.size_m))
        case Wall():
            return Outline.of(_wall_part(obstacle))


def _wall_part(wall: Wall) -> Part:
    (ax, ay), (bx, by) = wall.from_m, wall.to_m
    length = sqrt((bx - ax) ** 2 + (by - ay) ** 2) or 1.0
    nx, ny = -(by - ay) / length * wall.thickness_m / 2, (bx - ax) / length * wall.thickness_m / 2
    return Part(counter_clockwise(((ax + nx, ay + ny), (bx + nx, by + ny), (bx - nx, by - ny), (ax - nx, ay - ny))))


def wall_parts(field: FieldModel) -> tuple[Part, ...]:
    """Return everything solid around the field: side and end walls, corner walls, goals."""
    x, y, far = field.width_m / 2, field.length_m / 2, _SOLID_M
    parts = [_box(x, x + far, -y - far, y + far), _box(-x - far, -x, -y - far, y + far)]
    for end, sign in (("positive_y", 1.0), ("negative_y", -1.0)):
        goals = [goal for goal in field.goals.values() if goal.end == end]
        half = max((goal.width_m / 2 for goal in goals), default=0.0)
        depth = max((goal.depth_m for goal in goals), default=0.0)
        low, high = sorted((sign * y, sign * (y + far)))
        parts += [_box(half, x + far, low, high), _box(-x - far, -half, low, high)]
        back_low, back_high = sorted((sign * (y + depth), sign * (y + far)))
        parts.append(_box(-half, half, back_low, back_high) if goals else _box(-x, x, low, high))
    cut = field.corner_cut_m
    if cut > 0:
        parts += [
            Part(counter_clockwise(((sx * (x - cut), sy * y), (sx * x, sy * (y - cut)), (sx * x, sy * y))))
            for sx in (1, -1)
            for sy in (1, -1)
        ]
    return tuple(parts)


def _box(x_min: float, x_max: float, y_min: float, y_max: float) -> Part:
    return Part(((x_max, y_max), (x_min, y_max), (x_min, y_min), (x_max, y_min)))


def gap_m(first: Part, second: Part) -> float:
    """Return the gap between two parts in m; negative if they overlap (then only its sign means anything)."""
    radii = first.radius_m + second.radius_m
    apart = _apart(first.points, second.points)
    if apart < 0.0:
        return apart - radii
    return min(_nearest(first.points, second.points), _nearest(second.points, first.points)) - radii


def closer_than(first: Part, second: Part, limit_m: float) -> bool:
    """Return whether the gap between two parts is smaller than a limit in m, looking closely only where needed."""
    apart = _apart(first.points, second.points)
    radii = first.radius_m + second.radius_m
    if apart - radii >= limit_m:
        return False
    if radii == 0.0 and limit_m <= 0.0:  # whether polygons overlap is all that is asked, and that is known
        return True
    return gap_m(first, second) < limit_m


def _apart(first: Points, second: Points) -> float:
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


class Bodies:
    """The outlines of all entities and of everything that stands fast.

    Attributes:
        outlines: by entity index.
        fixed: parts of fixed obstacles, which count as bodies.
        walls: parts of the field's walls and goals, which do not.
        half_box_m: half widths, along x and y, of the box around field and goals, in m; nothing stands outside.
    """

    def __init__(self, scenario: Scenario, roster: Roster) -> None:
        outlines: list[Outline] = []
        for name in roster.entities:
            if name in scenario.robots:
                outlines.append(robot_outline(scenario.kits[scenario.robots[name].kit].chassis))
            elif name in scenario.balls:
                outlines.append(disc(scenario.balls[name].radius_m))
            else:
                outlines.append(obstacle_outline(scenario.obstacles[name]))
        fixed: list[Part] = []
        for name, obstacle in scenario.obstacles.items():
            if name not in roster.entities:
                fixed += obstacle_outline(obstacle).at(start_pose(scenario, name))
        self.outlines = tuple(outlines)
        self.fixed = tuple(fixed)
        self.walls = wall_parts(scenario.field)
        deepest_m = max((goal.depth_m for goal in scenario.field.goals.values()), default=0.0)
        self.half_box_m = (scenario.field.width_m / 2, scenario.field.length_m / 2 + deepest_m)

    def fits(self, entity: int, pose: Pose2, others: dict[int, Pose2], clearance_m: float) -> bool:
        """Return whether an entity can stand at a pose.

        Args:
            entity: index of the entity.
            pose: where it is to stand.
            others: the entities that stand on the field, by index.
            clearance_m: smallest gap to any other body; walls only must not be overlapped.
        """
        if abs(pose[0]) > self.half_box_m[0] or abs(pose[1]) > self.half_box_m[1]:
            return False
        outline = self.outlines[entity]
        parts = outline.at(pose)
        least = clearance_m - _TOUCHING_M
        for index, other in others.items():
            near = outline.reach_m + self.outlines[index].reach_m + clearance_m
            if (pose[0] - other[0]) ** 2 + (pose[1] - other[1]) ** 2 > near * near:
                continue
            if any(closer_than(a, b, least) for a in parts for b in self.outlines[index].at(other)):
                return False
        if any(closer_than(part, body, least) for part in parts for body in self.fixed):
            return False
        centre = (pose[:2],)
        near_walls = [wall for wall in self.walls if _apart(centre, wall.points) < outline.reach_m]
        return not any(closer_than(part, wall, -_TOUCHING_M) for part in parts for wall in near_walls)
