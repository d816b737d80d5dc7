"""Zones, gates and points against the floor: exact for straight edges."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import cos, hypot, pi, sin

from rcj_challenges.geometry.polygons import Point, distance_to_segment_m, side
from rcj_challenges.scenario.floor import Corners
from rcj_challenges.scenario.models.places import CircleZone, HalfPlaneZone, PolygonZone, RectZone, Zone

_FAR_M = 100.0
"""Stands for an open side; ten times the largest field."""
_NOTHING_M2 = 1e-12
_ARC_CORNERS = 180
_ALONG = 25


def zone_has_floor(zone: Zone, parts: Sequence[Corners]) -> bool:
    """Return whether a zone has a part of the floor in it, more than an edge."""
    return any(_covered(zone, part) for part in parts)


def _covered(zone: Zone, part: Corners) -> bool:
    if isinstance(zone, CircleZone):
        distances = [hypot(px - zone.centre_m[0], py - zone.centre_m[1]) for px, py in part]
        if zone.inverted:
            return max(distances) > zone.radius_m
        return _distance(zone.centre_m, part) < zone.radius_m
    inside = abs(_area(_clipped(zone_corners(zone), part)))
    return abs(_area(part)) - inside > _NOTHING_M2 if zone.inverted else inside > _NOTHING_M2


def zone_corners(zone: Zone) -> Corners:
    """Return the corners of a zone in m, not inverted; a circle has many, an open side is far away."""
    match zone:
        case RectZone():
            west = -_FAR_M if zone.x_min_m is None else zone.x_min_m
            east = _FAR_M if zone.x_max_m is None else zone.x_max_m
            south = -_FAR_M if zone.y_min_m is None else zone.y_min_m
            north = _FAR_M if zone.y_max_m is None else zone.y_max_m
            return ((west, south), (east, south), (east, north), (west, north))
        case HalfPlaneZone():
            (px, py), (nx, ny) = zone.through_m, zone.normal
            length = hypot(nx, ny)
            nx, ny = nx * _FAR_M / length, ny * _FAR_M / length
            return ((px + ny, py - nx), (px + ny + nx, py - nx + ny), (px - ny + nx, py + nx + ny), (px - ny, py + nx))
        case PolygonZone():
            return zone.points_m
        case CircleZone():
            return _ring(zone.centre_m, zone.radius_m, _ARC_CORNERS)


def _ring(centre: Point, radius_m: float, count: int) -> Corners:
    turns = (2 * pi * i / count for i in range(count))
    return tuple((centre[0] + radius_m * cos(turn), centre[1] + radius_m * sin(turn)) for turn in turns)


def _clipped(subject: Corners, window: Corners) -> Corners:
    """Return a polygon cut to a convex window that goes counter-clockwise (Sutherland and Hodgman)."""
    cut: list[Point] = list(subject)
    for a, b in zip(window, (*window[1:], window[0]), strict=True):
        kept: list[Point] = []
        for p, q in zip(cut, (*cut[1:], *cut[:1]), strict=True):
            side_p, side_q = side(a, b, p), side(a, b, q)
            if side_p >= 0:
                kept.append(p)
            if side_p * side_q < 0:
                share = side_p / (side_p - side_q)
                kept.append((p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1])))
        cut = kept
    return tuple(cut)


def _area(corners: Corners) -> float:
    edges = zip(corners, (*corners[1:], *corners[:1]), strict=True)
    return sum(ax * by - bx * ay for (ax, ay), (bx, by) in edges) / 2


def _distance(point: Point, part: Corners) -> float:
    """Return how far a point is from a convex part; 0 inside."""
    edges = [*pairwise(part), (part[-1], part[0])]
    if all(side(a, b, point) >= 0 for a, b in edges):
        return 0.0
    return min(distance_to_segment_m(*point, *a, *b) for a, b in edges)


def away_m(zone: Zone, point: Point) -> float:
    """Return how far a point is from a zone that is convex and not inverted, in m; 0 inside."""
    if isinstance(zone, CircleZone):
        return max(0.0, hypot(point[0] - zone.centre_m[0], point[1] - zone.centre_m[1]) - zone.radius_m)
    return _distance(point, zone_corners(zone))


def segment_has_floor(a: Point, b: Point, parts: Sequence[Corners]) -> bool:
    """Return whether a segment has a point on the floor."""
    return any(_segment_in(a, b, part) for part in parts)


def _segment_in(a: Point, b: Point, part: Corners) -> bool:
    low, high = 0.0, 1.0
    for p, q in zip(part, (*part[1:], part[0]), strict=True):
        side_a, side_b = side(p, q, a), side(p, q, b)
        if side_a < 0 and side_b < 0:
            return False
        if side_a * side_b < 0:
            share = side_a / (side_a - side_b)
            low, high = (max(low, share), high) if side_a < 0 else (low, min(high, share))
    return low <= high


def lies_in(point: Point, zone: Zone) -> bool:
    """Return whether a point is in a zone."""
    return _holds(zone_corners(zone), point) != zone.inverted


def points_in(zone: Zone) -> list[Point]:
    """Return points of a bounded zone on a grid of `_ALONG` times `_ALONG`, fewer where it is no rect."""
    corners = zone_corners(zone)
    (x_0, x_1), (y_0, y_1) = ((min(axis), max(axis)) for axis in zip(*corners, strict=True))
    grid = [(i + 0.5) / _ALONG for i in range(_ALONG)]
    points = [(x_0 + i * (x_1 - x_0), y_0 + j * (y_1 - y_0)) for i in grid for j in grid]
    return [point for point in points if _holds(corners, point)]


def _holds(corners: Corners, point: Point) -> bool:
    x, y = point
    inside = False
    for (ax, ay), (bx, by) in zip(corners, (*corners[1:], corners[0]), strict=True):
        if (ay > y) != (by > y) and x < ax + (bx - ax) * (y - ay) / (by - ay):
            inside = not inside
    return inside
