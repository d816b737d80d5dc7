"""Centres of zones and obstacles."""

from __future__ import annotations

from math import atan2

from rcj_challenges.scenario.models.field import Box, Cylinder, Obstacle, Wall
from rcj_challenges.scenario.models.places import CircleZone, RectZone, Zone


def centre_of(zone: Zone) -> tuple[float, float] | None:
    """Return the centre of a zone; None of one that has none, or several points with equal right to the name."""
    if zone.inverted:
        return None
    if isinstance(zone, CircleZone):
        return zone.centre_m
    sides = (zone.x_min_m, zone.x_max_m, zone.y_min_m, zone.y_max_m) if isinstance(zone, RectZone) else (None,) * 4
    x_min, x_max, y_min, y_max = sides
    if x_min is None or x_max is None or y_min is None or y_max is None:
        return None
    return (x_min + x_max) / 2, (y_min + y_max) / 2


def middle_of(obstacle: Obstacle) -> tuple[float, float, float]:
    """Return the pose of a fixed obstacle, [x, y, yaw] in m and rad: a wall from its middle along its line."""
    match obstacle:
        case Wall():
            (ax, ay), (bx, by) = obstacle.from_m, obstacle.to_m
            return (ax + bx) / 2, (ay + by) / 2, atan2(by - ay, bx - ax)
        case Box():
            return *obstacle.centre_m, obstacle.yaw_rad
        case Cylinder():
            return *obstacle.centre_m, 0.0
