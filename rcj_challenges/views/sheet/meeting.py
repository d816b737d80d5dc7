"""Whether zones may meet: who goes from one straight into the next has then not entered the several as one."""

from __future__ import annotations

from itertools import combinations
from math import inf

from rcj_challenges.scenario.models.places import CircleZone, PolygonZone, RectZone, Zone

_Box = tuple[float, float, float, float]
"""(x_min, x_max, y_min, y_max) in m."""


def may_meet(zones: list[Zone]) -> bool:
    """Return whether any two of these zones overlap or touch, or may do so: the boxes around them are compared."""
    boxes = [_box_around(zone) for zone in zones]
    return any(
        one[0] <= other[1] and other[0] <= one[1] and one[2] <= other[3] and other[2] <= one[3]
        for one, other in combinations(boxes, 2)
    )


def _box_around(zone: Zone) -> _Box:
    if zone.inverted:
        return -inf, inf, -inf, inf
    match zone:
        case RectZone():
            low, high = (zone.x_min_m, zone.y_min_m), (zone.x_max_m, zone.y_max_m)
            (x_min, y_min), (x_max, y_max) = (
                [limit if one is None else one for one in ends] for ends, limit in ((low, -inf), (high, inf))
            )
            return x_min, x_max, y_min, y_max
        case CircleZone():
            (x, y), far = zone.centre_m, zone.radius_m
            return x - far, x + far, y - far, y + far
        case PolygonZone():
            xs, ys = zip(*zone.points_m, strict=True)
            return min(xs), max(xs), min(ys), max(ys)
    return -inf, inf, -inf, inf
