"""Zones as polygons, cut to what is on the paper; where things are at the start; points in words."""

from __future__ import annotations

import math

from rcj_challenges.scenario.models.field import Wall
from rcj_challenges.scenario.models.places import CircleZone, HalfPlaneZone, PolygonZone, RectZone, Zone
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.drawing.labels import Box, Point


def zone_outline(zone: Zone, bounds: Box) -> list[Point]:
    """Return a zone's outline in m (``inverted`` not regarded); open sides end at the bounds."""
    if isinstance(zone, RectZone):
        left, bottom, right, top = bounds
        x0 = left if zone.x_min_m is None else zone.x_min_m
        x1 = right if zone.x_max_m is None else zone.x_max_m
        y0 = bottom if zone.y_min_m is None else zone.y_min_m
        y1 = top if zone.y_max_m is None else zone.y_max_m
        return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]
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
    return _half_plane(zone, bounds)


def _half_plane(zone: HalfPlaneZone, bounds: Box) -> list[Point]:
    """Return the part of the paper on the normal's side of the line."""
    left, bottom, right, top = bounds
    corners = [(left, bottom), (right, bottom), (right, top), (left, top)]
    px, py = zone.through_m
    nx, ny = zone.normal
    depths = [(x - px) * nx + (y - py) * ny for x, y in corners]
    outline: list[Point] = []
    for k, corner in enumerate(corners):
        following, depth, next_depth = corners[(k + 1) % 4], depths[k], depths[(k + 1) % 4]
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


def turned(points: list[Point], at: Point, yaw_rad: float) -> list[Point]:
    """Return points of a body's own frame (x forward) as points of the field."""
    c, s = math.cos(yaw_rad), math.sin(yaw_rad)
    return [(at[0] + c * x - s * y, at[1] + s * x + c * y) for x, y in points]


def box(width_m: float, height_m: float) -> list[Point]:
    """Return the corners of a box around the origin."""
    x, y = width_m / 2, height_m / 2
    return [(-x, -y), (x, -y), (x, y), (-x, y)]


def zone_words(zone: Zone) -> str:
    """Return a zone's numbers in words: ``-0.2 < x < 0.2, y > 0.59``."""
    words = _shape_words(zone)
    return f"all but {words}" if zone.inverted else words


def point_words(point: Point) -> str:
    """Return ``(x, y)`` in m."""
    return f"({point[0]:g}, {point[1]:g})"


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


def home(scenario: Scenario, entity: str) -> Point:
    """Return where an entity is at the start, in m."""
    if entity in scenario.robots:
        start = scenario.robots[entity].start
        return start.x_m, start.y_m
    if entity in scenario.balls:
        return scenario.balls[entity].start_m
    obstacle = scenario.obstacles[entity]
    return obstacle.from_m if isinstance(obstacle, Wall) else obstacle.centre_m
