"""Whether zones may meet: who goes from one straight into the next has then not entered the several as one."""

from __future__ import annotations

from itertools import combinations
from math import inf

from rcj_challenges.scenario.floor_shapes import zone_corners
from rcj_challenges.scenario.models.places import Zone

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
    xs, ys = zip(*zone_corners(zone), strict=True)
    return min(xs), max(xs), min(ys), max(ys)
