"""Zones as regions, and random points of them, every point equally likely."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from itertools import accumulate
from math import cos, inf, pi, sin, sqrt, tau

from rcj_challenges.core.amounts import add_up
from rcj_challenges.geometry.regions import Circle, HalfPlane, Outlined, Outside, Polygon, Rect
from rcj_challenges.scenario.models import places as models

Point = tuple[float, float]
Sampler = Callable[[random.Random], Point]

_MAX_TRIES = 10_000
"""A sliver of a ten-thousandth of its box would be drawn in vain."""


def region_of(zone: models.Zone) -> Outlined:
    """Return the region of a zone of the scenario."""
    region: Outlined
    match zone:
        case models.RectZone():
            sides = (zone.x_min_m, -inf), (zone.x_max_m, inf), (zone.y_min_m, -inf), (zone.y_max_m, inf)
            region = Rect(*(far_m if side_m is None else side_m for side_m, far_m in sides))
        case models.CircleZone():
            region = Circle(zone.middle_m, zone.radius_m)
        case models.PolygonZone():
            region = Polygon(zone.points_m)
        case models.HalfPlaneZone():
            region = HalfPlane(zone.through_m, zone.normal)
    return Outside(region) if zone.inverted else region


def point_sampler(zones: Mapping[str, models.Zone]) -> Sampler:
    """Return a function that draws a point in at least one of these zones, every such point equally likely.

    Raises:
        ValueError: a zone has no end in some direction.
    """
    areas_m2, samplers = zip(*(_of_one(zone, name) for name, zone in zones.items()), strict=True)
    return samplers[0] if len(samplers) == 1 else _of_several([*map(region_of, zones.values())], areas_m2, samplers)


def _of_several(regions: Sequence[Outlined], areas_m2: Sequence[float], samplers: Sequence[Sampler]) -> Sampler:
    """Draw a zone by its area, then a point of it; where zones overlap, a point is drawn for each and kept for one."""
    reach = list(accumulate(areas_m2))

    def in_any(rng: random.Random) -> Point:
        for _ in range(_MAX_TRIES):
            [sample] = rng.choices(samplers, cum_weights=reach)
            point = sample(rng)
            if rng.random() * sum(region.contains(*point) for region in regions) < 1.0:  # integers
                break
        return point

    return in_any


def _of_one(zone: models.Zone, name: str) -> tuple[float, Sampler]:
    """Return the area of a zone in m², and a function that draws a point of it."""
    if not zone.inverted:
        match zone:
            case models.RectZone(x_min_m=float() | int() as x_0, x_max_m=float() | int() as x_1,
                                 y_min_m=float() | int() as y_0, y_max_m=float() | int() as y_1):  # fmt: skip
                return (x_1 - x_0) * (y_1 - y_0), lambda rng: (rng.uniform(x_0, x_1), rng.uniform(y_0, y_1))
            case models.CircleZone(middle_m=centre, radius_m=radius):
                return pi * radius**2, _circle_sampler(centre, radius)
            case models.PolygonZone(points_m=points):
                edges = zip(points, points[1:] + points[:1], strict=True)
                area_m2 = abs(add_up(ax * by - bx * ay for (ax, ay), (bx, by) in edges)) / 2
                return area_m2, _polygon_sampler(points)
    message = f"uniform_in: the zone {name!r} is not bounded on all sides"
    raise ValueError(message)


def _circle_sampler(centre: Point, radius: float) -> Sampler:
    x, y = centre

    def in_circle(rng: random.Random) -> Point:
        turn, far = rng.uniform(0, tau), radius * sqrt(rng.random())
        return (x + far * cos(turn), y + far * sin(turn))

    return in_circle


def _polygon_sampler(points: tuple[Point, ...]) -> Sampler:
    polygon = Polygon(points)
    xs, ys = [x for x, _ in points], [y for _, y in points]

    def in_polygon(rng: random.Random) -> Point:
        for _ in range(_MAX_TRIES):
            point = (rng.uniform(min(xs), max(xs)), rng.uniform(min(ys), max(ys)))
            if polygon.contains(*point):
                return point
        return points[0]

    return in_polygon
