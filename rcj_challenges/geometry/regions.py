"""Plane geometry of zones and gates: is a centre inside, how far is it, and around it, how far nothing can change.

A *cell* is a box around a centre in which the answer is the same everywhere. One box per entity and sub-step is checked
instead of every zone of every rule; only a centre that leaves its box is looked at closely. A cell is
``(x_low, x_high, y_low, y_high)`` in m; a centre is in it when it is strictly between, so a centre exactly on a
boundary is always looked at closely.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable
from math import inf, sqrt

from rcj_challenges.geometry.polygons import distance_to_segment_m

Cell = tuple[float, float, float, float]
"""(x_low, x_high, y_low, y_high) in m; strictly between is inside."""

EVERYWHERE: Cell = (-inf, inf, -inf, inf)
NOWHERE: Cell = (inf, -inf, inf, -inf)
# A box of half side 0.7 d lies inside the circle of radius d (1/sqrt(2) = 0.7071, the rest is room for rounding).
_BOX_IN_CIRCLE = 0.7
_ROUNDING_M = 1e-9


def common_cell(first: Cell, second: Cell) -> Cell:
    """Return the box that lies in both cells (empty if they do not meet)."""
    return (max(first[0], second[0]), min(first[1], second[1]), max(first[2], second[2]), min(first[3], second[3]))


def box_around(x_m: float, y_m: float, clear_m: float) -> Cell:
    """Return a cell around a centre to which the nearest boundary is ``clear_m`` away."""
    half = max(0.0, clear_m - _ROUNDING_M) * _BOX_IN_CIRCLE  # on the boundary itself there is no room
    return (x_m - half, x_m + half, y_m - half, y_m + half)


def cell_beside_circle(x_m: float, y_m: float, centre_m: tuple[float, float], radius_m: float) -> Cell:
    """Return a cell around a point that the line of a circle does not reach into, as large as is easy to compute."""
    dx, dy = x_m - centre_m[0], y_m - centre_m[1]
    far = max(abs(dx), abs(dy))
    if far < _BOX_IN_CIRCLE * radius_m:
        return box_around(*centre_m, radius_m)
    side = cell_beside_square(x_m, y_m, centre_m, radius_m)
    return side if far > radius_m else box_around(x_m, y_m, abs(sqrt(dx * dx + dy * dy) - radius_m))


def cell_beside_square(x_m: float, y_m: float, centre_m: tuple[float, float], half_m: float) -> Cell:
    """Return the inside of an upright square, or all that lies beyond one of its sides, as the point does."""
    (x, y), dx, dy = centre_m, x_m - centre_m[0], y_m - centre_m[1]
    # A little beyond the sides, so that rounding cannot put a point of the cell on the other side.
    out, inner = half_m + _ROUNDING_M, half_m - _ROUNDING_M
    if abs(dx) <= half_m and abs(dy) <= half_m:
        return (x - inner, x + inner, y - inner, y + inner)
    if abs(dx) >= abs(dy):
        return (x + out, inf, -inf, inf) if dx > 0 else (-inf, x - out, -inf, inf)
    return (-inf, inf, y + out, inf) if dy > 0 else (-inf, inf, -inf, y - out)


class Region(ABC):
    """A part of the plane.

    Attributes:
        anchors: indices of the entities with which it moves.
    """

    anchors: tuple[int, ...] = ()

    @abstractmethod
    def contains(self, x_m: float, y_m: float) -> bool:
        """Return whether the point is in it; a point on the boundary is not (all limits are strict)."""

    @abstractmethod
    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return a cell around the point in which `contains` gives the same answer."""


class Outlined(Region):
    """A part of the plane with a line around it, or beside it: what a zone is."""

    @abstractmethod
    def outline_m(self, x_m: float, y_m: float) -> float:
        """Return the distance in m of a point, inside or outside, from the outline."""

    def away_m(self, x_m: float, y_m: float) -> float | None:
        """Return the distance in m of a point from the region: 0 inside and on the outline; None: it is nowhere."""
        return 0.0 if self.contains(x_m, y_m) else self.outline_m(x_m, y_m)


class Rect(Outlined):
    """An upright rectangle; open sides are infinite."""

    def __init__(self, x_min_m: float, x_max_m: float, y_min_m: float, y_max_m: float) -> None:
        self._sides = (x_min_m, x_max_m, y_min_m, y_max_m)

    def contains(self, x_m: float, y_m: float) -> bool:
        """Return whether the point is strictly between all four sides."""
        x_min, x_max, y_min, y_max = self._sides
        return x_min < x_m < x_max and y_min < y_m < y_max

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return the rectangle itself, or all that lies beyond one of its sides, as the point does."""
        x_min, x_max, y_min, y_max = self._sides
        if x_m <= x_min:
            return (-inf, x_min, -inf, inf)
        if x_m >= x_max:
            return (x_max, inf, -inf, inf)
        if y_m <= y_min:
            return (-inf, inf, -inf, y_min)
        if y_m >= y_max:
            return (-inf, inf, y_max, inf)
        return self._sides

    def outline_m(self, x_m: float, y_m: float) -> float:
        """Return the distance to the nearest side that is not open, or from outside to the nearest corner."""
        x_min, x_max, y_min, y_max = self._sides
        beyond_x, beyond_y = max(x_min - x_m, x_m - x_max), max(y_min - y_m, y_m - y_max)
        if beyond_x <= 0.0 and beyond_y <= 0.0:
            return abs(max(beyond_x, beyond_y))  # never -0.0, which would be printed as such
        beyond_x, beyond_y = max(0.0, beyond_x), max(0.0, beyond_y)
        return sqrt(beyond_x * beyond_x + beyond_y * beyond_y)


class Circle(Outlined):
    """A disc."""

    def __init__(self, centre_m: tuple[float, float], radius_m: float) -> None:
        self._x, self._y = centre_m
        self._radius = radius_m

    def contains(self, x_m: float, y_m: float) -> bool:
        """Return whether the point is nearer to the centre than the radius."""
        dx, dy = x_m - self._x, y_m - self._y
        return sqrt(dx * dx + dy * dy) < self._radius

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return a box that stays clear of the circle's line."""
        return cell_beside_circle(x_m, y_m, (self._x, self._y), self._radius)

    def outline_m(self, x_m: float, y_m: float) -> float:
        """Return the distance to the circle's line."""
        dx, dy = x_m - self._x, y_m - self._y
        return abs(sqrt(dx * dx + dy * dy) - self._radius)


class HalfPlane(Outlined):
    """All points beyond a line, on the side that the normal shows to."""

    def __init__(self, through_m: tuple[float, float], normal: tuple[float, float]) -> None:
        length = sqrt(normal[0] ** 2 + normal[1] ** 2)
        self._x, self._y = through_m
        self._nx, self._ny = (normal[0] / length, normal[1] / length) if length else (0.0, 0.0)

    def _height(self, x_m: float, y_m: float) -> float:
        return (x_m - self._x) * self._nx + (y_m - self._y) * self._ny

    def contains(self, x_m: float, y_m: float) -> bool:
        """Return whether the point is strictly beyond the line."""
        return self._height(x_m, y_m) > 0.0

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return a box that stays clear of the line."""
        return box_around(x_m, y_m, self.outline_m(x_m, y_m))

    def outline_m(self, x_m: float, y_m: float) -> float:
        """Return the distance to the line."""
        return abs(self._height(x_m, y_m))


class Polygon(Outlined):
    """A simple polygon."""

    def __init__(self, points_m: tuple[tuple[float, float], ...]) -> None:
        self.points = points_m
        self._edges = tuple(zip(points_m, (*points_m[1:], points_m[0]), strict=True))

    def contains(self, x_m: float, y_m: float) -> bool:
        """Return whether the point is inside (a ray to +x crosses the outline an odd number of times)."""
        inside = False
        for (ax, ay), (bx, by) in self._edges:
            if (ay > y_m) != (by > y_m):
                across = (bx - ax) * (y_m - ay) / (by - ay) + ax
                if x_m == across:
                    return False
                if x_m < across:
                    inside = not inside
            elif ay == by == y_m and min(ax, bx) <= x_m <= max(ax, bx):
                return False
        return inside and (x_m, y_m) not in self.points

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return a box that stays clear of the outline."""
        return box_around(x_m, y_m, self.outline_m(x_m, y_m))

    def outline_m(self, x_m: float, y_m: float) -> float:
        """Return the distance to the nearest edge."""
        return min(distance_to_segment_m(x_m, y_m, *a, *b) for a, b in self._edges)


class Outside(Outlined):
    """Everything but a region; its outline is the same."""

    def __init__(self, region: Outlined) -> None:
        self._region, self.anchors = region, region.anchors

    def contains(self, x_m: float, y_m: float) -> bool:
        """Return whether the point is not in the region."""
        return not self._region.contains(x_m, y_m)

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return the region's own cell: the answer changes in the same places."""
        return self._region.cell(x_m, y_m)

    def outline_m(self, x_m: float, y_m: float) -> float:
        """Return the distance to the region's own outline."""
        return self._region.outline_m(x_m, y_m)


class AnyOf(Region):
    """Several regions taken as one."""

    def __init__(self, regions: tuple[Region, ...]) -> None:
        self._regions = regions
        self.anchors = tuple(anchor for region in regions for anchor in region.anchors)

    def contains(self, x_m: float, y_m: float) -> bool:
        """Return whether the point is in any of them."""
        for region in self._regions:  # noqa: SIM110 - a generator is slower, and this is asked in every sub-step
            if region.contains(x_m, y_m):
                return True
        return False

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return the cell of the one that holds the point, or what all of them leave free."""
        cell = EVERYWHERE
        for region in self._regions:
            own = region.cell(x_m, y_m)
            if region.contains(x_m, y_m):
                return own
            cell = common_cell(cell, own)
        return cell


class Drawn(Region):
    """The region that a draw has decided; trackers start again when the draw changes."""

    def __init__(self, now: Callable[[], Region]) -> None:
        self._now = now

    def contains(self, x_m: float, y_m: float) -> bool:
        """Return whether the point is in the one that is drawn now."""
        return self._now().contains(x_m, y_m)

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return the cell of the one that is drawn now."""
        return self._now().cell(x_m, y_m)


class FarFrom(Region):
    """All points further from an anchor than a limit; the anchor moves when the entity is put elsewhere.

    Args:
        limit_m: strict limit in m.
        square: True measures the larger of the shifts in x and in y, False the straight line.
    """

    def __init__(self, limit_m: float, *, square: bool) -> None:
        self.limit_m = limit_m
        self._square = square
        self.anchor = (0.0, 0.0)

    def distance_m(self, x_m: float, y_m: float) -> float:
        """Return the distance in m of the point from the anchor."""
        dx, dy = x_m - self.anchor[0], y_m - self.anchor[1]
        return max(abs(dx), abs(dy)) if self._square else sqrt(dx * dx + dy * dy)

    def contains(self, x_m: float, y_m: float) -> bool:
        """Return whether the point is further away than the limit."""
        return self.distance_m(x_m, y_m) > self.limit_m

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return a box that stays clear of the limit."""
        beside = cell_beside_square if self._square else cell_beside_circle
        return beside(x_m, y_m, self.anchor, self.limit_m)


def crossing(
    start: tuple[float, float], end: tuple[float, float], post_a: tuple[float, float], post_b: tuple[float, float]
) -> int:
    """Return 1 if the way from start to end crosses the gate forward, -1 backward, 0 if it does not.

    Forward is from the right of the gate to its left, seen from post a to post b. A centre on the gate's line counts
    as still on its right, so that no way of two pieces is counted twice or missed.
    """
    (ax, ay), (bx, by) = post_a, post_b
    gx, gy = bx - ax, by - ay
    height_0 = gx * (start[1] - ay) - gy * (start[0] - ax)
    height_1 = gx * (end[1] - ay) - gy * (end[0] - ax)
    if (height_0 > 0.0) == (height_1 > 0.0):
        return 0
    share = height_0 / (height_0 - height_1)
    x = start[0] + share * (end[0] - start[0])
    y = start[1] + share * (end[1] - start[1])
    along = (x - ax) * gx + (y - ay) * gy
    if not 0.0 <= along <= gx * gx + gy * gy:
        return 0
    return 1 if height_1 > 0.0 else -1
