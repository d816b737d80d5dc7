"""Lines around zones, gates and walls: all points of the paper that are as far from one as a rule asks."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence

from rcj_challenges.referee.regions import region_of
from rcj_challenges.scenario.models.field import Wall
from rcj_challenges.scenario.models.places import CircleZone, Gate, Zone
from rcj_challenges.scenario.polygons import distance_to_segment_m
from rcj_challenges.views.drawing.labels import Box, Point
from rcj_challenges.views.drawing.shapes import whole_outline

_STEP_M = 0.01
_ARC_STEPS = 72
_SAME_M = 1e-6
_BESIDE_M = 1.0
"""Open sides end so far beside the paper and the line around them that their ends show nowhere."""


def lines_around(place: Zone | Gate | Wall, far_m: float, paper: Box) -> list[list[Point]]:
    """Return the lines of which every point is ``far_m`` from a zone, a wall, or a gate that does not move.

    Straight and round pieces are tried all along the outline, on both sides; what is nearer to another part of it, or
    lies inside, is no part of the line.
    """
    left, bottom, right, top = paper
    away_m = measure(place)

    def counts(point: Point) -> bool:
        x, y = point
        return left <= x <= right and bottom <= y <= top and abs(away_m(x, y) - far_m) <= _SAME_M

    found: list[list[Point]] = []
    for piece, is_straight in _pieces(place, far_m, paper):
        found += [[run[0], run[-1]] if is_straight else run for run in _runs(piece, counts)]
    return found


def measure(place: Zone | Gate | Wall) -> Callable[[float, float], float]:
    """Return what tells how far the point (x, y) is from a zone, a wall or a gate that does not move, in m."""
    if isinstance(place, Gate | Wall):
        return lambda x, y: distance_to_segment_m(x, y, *place.from_m, *place.to_m)
    return region_of(place).away_m


def _pieces(place: Zone | Gate | Wall, far_m: float, paper: Box) -> Iterator[tuple[list[Point], bool]]:
    """Yield pieces of which the line may consist, as points, and whether they are straight."""
    if isinstance(place, CircleZone):
        yield from ((_circle(place.centre_m, place.radius_m + side * far_m), False) for side in (1, -1))
        return
    corners = _corners(place, far_m, paper)
    for a, b in zip(corners, (*corners[1:], *corners[:1]), strict=True):
        length = math.dist(a, b)
        for side in (1, -1):
            dx, dy = side * far_m * (b[1] - a[1]) / length, side * far_m * (a[0] - b[0]) / length
            yield _straight((a[0] + dx, a[1] + dy), (b[0] + dx, b[1] + dy), paper), True
        yield _circle(a, far_m), False


def _straight(a: Point, b: Point, paper: Box) -> list[Point]:
    """Return points of a segment as far as it lies on the paper: a zone may reach for miles."""
    left, bottom, right, top = paper
    first, last = 0.0, 1.0
    for at, to, low, high in ((a[0], b[0], left, right), (a[1], b[1], bottom, top)):
        if at == to:
            if not low <= at <= high:
                return []
            continue
        ends = sorted(((low - at) / (to - at), (high - at) / (to - at)))
        first, last = max(first, ends[0]), min(last, ends[1])
    if first > last:
        return []
    steps = max(1, math.ceil(math.dist(a, b) * (last - first) / _STEP_M))
    shares = [first + k / steps * (last - first) for k in range(steps + 1)]
    return [(a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])) for share in shares]


def _corners(place: Zone | Gate | Wall, far_m: float, paper: Box) -> list[Point]:
    if isinstance(place, Gate | Wall):
        return [place.from_m, place.to_m]
    beside = far_m + _BESIDE_M
    left, bottom, right, top = paper
    return whole_outline(place, (left - beside, bottom - beside, right + beside, top + beside))


def _circle(centre: Point, radius_m: float) -> list[Point]:
    turns = (math.tau * k / _ARC_STEPS for k in range(_ARC_STEPS + 1))
    return [(centre[0] + radius_m * math.cos(turn), centre[1] + radius_m * math.sin(turn)) for turn in turns]


def _runs(points: Sequence[Point], counts: Callable[[Point], bool]) -> Iterator[list[Point]]:
    """Yield the stretches of points that count, of two at least."""
    run: list[Point] = []
    for point in points:
        if counts(point):
            run.append(point)
            continue
        if len(run) > 1:
            yield run
        run = []
    if len(run) > 1:
        yield run
