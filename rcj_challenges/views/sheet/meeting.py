"""Whether zones may meet: who goes from one straight into the next has then not entered the several as one."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, product
from math import inf

from rcj_challenges.scenario.floor_shapes import zone_corners
from rcj_challenges.scenario.models.places import Zone

_Box = tuple[float, float, float, float]
"""(x_min, x_max, y_min, y_max) in m."""


def may_meet(several: Sequence[Sequence[Zone]]) -> bool:
    """Return whether any two of several zones overlap or touch, or may do so: the boxes around them are compared.

    Args:
        several: for each of them the zones of which it may be any: one, or those among which a draw decides.
    """
    boxes = [[_box_around(zone) for zone in zones] for zones in several]
    return any(
        one[0] <= other[1] and other[0] <= one[1] and one[2] <= other[3] and other[2] <= one[3]
        for here, there in combinations(boxes, 2)
        for one, other in product(here, there)
    )


def _box_around(zone: Zone) -> _Box:
    if zone.inverted:
        return -inf, inf, -inf, inf
    xs, ys = zip(*zone_corners(zone), strict=True)
    return min(xs), max(xs), min(ys), max(ys)
