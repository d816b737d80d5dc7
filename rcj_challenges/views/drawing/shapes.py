"""Zones as polygons that end at the paper, lines that end at the walls, and points as text."""

from __future__ import annotations

import math

from rcj_challenges.scenario.models.field import FieldModel, Goal
from rcj_challenges.scenario.models.places import CircleZone, HalfPlaneZone, PolygonZone, RectZone, Zone

Point = tuple[float, float]
Box = tuple[float, float, float, float]
"""Left, bottom, right and top, in m."""

FORWARD_M = 0.05


def zone_outline(zone: Zone, bounds: Box) -> list[Point]:
    """Return a zone's outline in m without regard to ``inverted``, clipped at bounds; empty if it is outside."""
    left, bottom, right, top = bounds
    outline = _whole_outline(zone, bounds)
    for through, normal in (((left, 0), (1, 0)), ((right, 0), (-1, 0)), ((0, bottom), (0, 1)), ((0, top), (0, -1))):
        outline = _beyond(outline, through, normal)
    return outline


def visible_outline(zone: Zone, field: FieldModel, paper: Box) -> list[Point]:
    """Return the part of a zone's outline that is drawn, without regard to ``inverted``; empty if there is none.

    A zone with an open side ends at the walls, because it would cover the goals and everything around the field. If it
    begins behind the floor, it ends where the goals do.
    """
    if not _is_open(zone):
        return zone_outline(zone, paper)
    return floor_outline(zone, field) or zone_outline(zone, _with_goals(field)) or zone_outline(zone, paper)


def _with_goals(field: FieldModel) -> Box:
    """Return the box around the floor and the goals."""
    depth_m = max((goal.depth_m for goal in field.goals.values()), default=0.0)
    w, h = field.width_m / 2, field.length_m / 2 + depth_m
    return -w, -h, w, h


def floor_of(field: FieldModel) -> list[Point]:
    """Return the outline of the floor inside the walls, without the goals."""
    w, h, cut = field.width_m / 2, field.length_m / 2, field.corner_cut_m
    return [(w - cut, h), (w, h - cut), (w, -h + cut), (w - cut, -h),
            (-w + cut, -h), (-w, -h + cut), (-w, h - cut), (-w + cut, h)]  # fmt: skip


def goal_floor(goal: Goal, field: FieldModel) -> list[Point]:
    """Return the corners of the floor inside a goal, the two on the goal line first."""
    sign = 1 if goal.end == "positive_y" else -1
    near, half = sign * field.length_m / 2, goal.width_m / 2
    far = near + sign * goal.depth_m
    return [(-half, near), (half, near), (half, far), (-half, far)]


def floor_outline(zone: Zone, field: FieldModel) -> list[Point]:
    """Return the outline of the part of a zone that lies on the floor; empty if none of it does."""
    w, h = field.width_m / 2, field.length_m / 2
    outline = zone_outline(zone, (-w, -h, w, h))
    for x, y in ((1, 1), (1, -1), (-1, 1), (-1, -1)) if field.corner_cut_m else ():
        outline = _beyond(outline, (x * (w - field.corner_cut_m), y * h), (-x, -y))
    return outline


def _is_open(zone: Zone) -> bool:
    if isinstance(zone, RectZone):
        return None in (zone.x_min_m, zone.x_max_m, zone.y_min_m, zone.y_max_m)
    return isinstance(zone, HalfPlaneZone)


def _whole_outline(zone: Zone, bounds: Box) -> list[Point]:
    """Return a zone's outline as far as it reaches; open sides end at the bounds."""
    left, bottom, right, top = bounds
    if isinstance(zone, RectZone):
        x0 = left if zone.x_min_m is None else zone.x_min_m
        x1 = right if zone.x_max_m is None else zone.x_max_m
        y0 = bottom if zone.y_min_m is None else zone.y_min_m
        y1 = top if zone.y_max_m is None else zone.y_max_m
        # An open side that begins beyond the bounds would end before it begins.
        return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)] if x0 < x1 and y0 < y1 else []
    if isinstance(zone, CircleZone):
        x, y = zone.centre_m
        steps = 72
        return [
            (
                x + zone.radius_m * math.cos(math.tau * k / steps),
                y + zone.radius_m * math.sin(math.tau * k / steps),
            )
            for k in range(steps)
        ]
    if isinstance(zone, PolygonZone):
        return list(zone.points_m)
    return _beyond([(left, bottom), (right, bottom), (right, top), (left, top)], zone.through_m, zone.normal)


def _beyond(corners: list[Point], through: Point, normal: Point) -> list[Point]:
    """Return the part of a polygon on the normal's side of a line."""
    px, py = through
    nx, ny = normal
    depths = [(x - px) * nx + (y - py) * ny for x, y in corners]
    outline: list[Point] = []
    for k, corner in enumerate(corners):
        after = (k + 1) % len(corners)
        following, depth, next_depth = corners[after], depths[k], depths[after]
        if depth >= 0:
            outline.append(corner)
        if (depth < 0) != (next_depth < 0):
            share = depth / (depth - next_depth)
            outline.append(
                (
                    corner[0] + share * (following[0] - corner[0]),
                    corner[1] + share * (following[1] - corner[1]),
                )
            )
    return outline


def middle(outline: list[Point], bounds: Box) -> Point:
    """Return a point for a label: the middle of what of the outline is on the paper."""
    inside = [(min(max(x, bounds[0]), bounds[2]), min(max(y, bounds[1]), bounds[3])) for x, y in outline]
    xs, ys = [x for x, _ in inside], [y for _, y in inside]
    return (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2


def corners_of(bounds: Box) -> list[Point]:
    """Return the corners of a box, clockwise."""
    left, bottom, right, top = bounds
    return [(left, top), (right, top), (right, bottom), (left, bottom)]


def visible_line(start: Point, end: Point, field: FieldModel) -> tuple[Point, Point] | None:
    """Return the part of a line inside the walls; None if there is none.

    A line that ends outside is cut at the walls, or where the goals end if none of it is on the floor.
    """
    around = _with_goals(field)
    if all(around[0] <= x <= around[2] and around[1] <= y <= around[3] for x, y in (start, end)):
        return start, end
    return _inside(start, end, floor_of(field)) or _inside(start, end, corners_of(around))


def _inside(start: Point, end: Point, corners: list[Point]) -> tuple[Point, Point] | None:
    """Return the part of a line inside a convex polygon, whose corners stand clockwise."""
    enters, leaves = 0.0, 1.0
    for k, (x, y) in enumerate(corners):
        normal = (y - corners[k - 1][1], corners[k - 1][0] - x)
        depth, end_depth = ((px - x) * normal[0] + (py - y) * normal[1] for px, py in (start, end))
        if depth < 0 and end_depth < 0:
            return None
        if depth < 0:
            enters = max(enters, depth / (depth - end_depth))
        elif end_depth < 0:
            leaves = min(leaves, depth / (depth - end_depth))
    dx, dy = end[0] - start[0], end[1] - start[1]
    at = [(start[0] + share * dx, start[1] + share * dy) for share in (enters, leaves)]
    return (at[0], at[1]) if enters < leaves else None


def turned(points: list[Point], at: Point, yaw_rad: float) -> list[Point]:
    """Return points of a body's own frame (x forward) as points of the field."""
    c, s = math.cos(yaw_rad), math.sin(yaw_rad)
    return [(at[0] + c * x - s * y, at[1] + s * x + c * y) for x, y in points]


def forward_mark(start: Point, end: Point, length_m: float = FORWARD_M) -> tuple[Point, Point]:
    """Return both ends of a gate's forward mark: when driving forward, the first post is on the left."""
    x, y = (start[0] + end[0]) / 2, (start[1] + end[1]) / 2
    share = length_m / (math.dist(start, end) or 1.0)
    return (x, y), (x - share * (end[1] - start[1]), y + share * (end[0] - start[0]))


def box(width_m: float, height_m: float) -> list[Point]:
    """Return the corners of a box around the origin."""
    x, y = width_m / 2, height_m / 2
    return [(-x, -y), (x, -y), (x, y), (-x, y)]


def shifted(point: Point, by: Point) -> Point:
    """Return a point so far from another one."""
    return point[0] + by[0], point[1] + by[1]


def zone_words(zone: Zone) -> str:
    """Return a zone's numbers in words: ``-0.2 < x < 0.2, y > 0.59``."""
    words = _shape_words(zone)
    return f"all but {words}" if zone.inverted else words


def point_words(point: Point) -> str:
    """Return ``(x, y)`` in m."""
    return f"({point[0] + 0.0:g}, {point[1] + 0.0:g})"  # adding 0 makes no -0


def _shape_words(zone: Zone) -> str:
    if isinstance(zone, RectZone):
        sides = (_range_words("x", zone.x_min_m, zone.x_max_m), _range_words("y", zone.y_min_m, zone.y_max_m))
        return ", ".join(side for side in sides if side) or "everywhere"
    if isinstance(zone, CircleZone):
        return f"within {zone.radius_m:g} of {point_words(zone.centre_m)}"
    if isinstance(zone, PolygonZone):
        return "polygon " + " ".join(map(point_words, zone.points_m))
    return f"beyond {point_words(zone.through_m)} towards {point_words(zone.normal)}"


def _range_words(axis: str, low: float | None, high: float | None) -> str:
    if low is None:
        return "" if high is None else f"{axis} < {high:g}"
    return f"{axis} > {low:g}" if high is None else f"{low:g} < {axis} < {high:g}"
