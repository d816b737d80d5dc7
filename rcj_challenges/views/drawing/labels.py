"""Where the labels of a drawing stand: near what they name, and in the way of nothing else.

Each label has candidate places: inside the area that it names, or in rings around the thing that it names, the nearest
first. It takes the one that is in the way of least. As a label that is placed later may leave a better place to an
earlier one, all of them are looked at again until none moves. Nothing here depends on chance or on the order of a set.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Generic, TypeVar

from rcj_challenges.scenario.polygons import side

Point = tuple[float, float]
Box = tuple[float, float, float, float]
Segment = tuple[Point, Point]
_Thing = TypeVar("_Thing")

LABEL_PX = 11.0
"""Size of the label font."""

CHARACTER_PX = 6.1
"""Width of a character of that size. In Arial the mean is 5.2, in wide fonts such as Verdana 6.1; nobody knows which
font a reader has, and a label that gets more room than it needs is still readable."""

_GAP_PX = 4.0
_RING_PX = 9.0
_WIDER_AFTER = 8
_LEADER_FROM_PX = 11.0
"""From this gap on a line leads from the label to what it names."""
_PASSES, _MANY_LABELS = 4, 60
"""How often all labels are looked at; of more than so many once, as each pass then takes long."""

_CELL_PX = 64.0
_PATIENCE = 48
"""How many places are looked at after the best one so far, if that covers no label: three rings further out."""

# What it costs to be in the way, in pixels of distance: of a label most, of a thin line little.
_ON_A_LABEL, _ON_A_LABEL_PER_PX2 = 3000.0, 20.0
_ON_A_SOLID, _ON_A_SOLID_PER_PX2 = 60.0, 2.0
_ON_ANOTHERS_BODY = 150.0
_LEADER_OVER_LABEL = 1500.0
_LEADER_OVER_LEADER = 150.0
_LEADER_OVER_SOLID = 40.0
_LEADER = 12.0
_IN_A_SMALLER_AREA = 20.0
_ACROSS_ITS_OWN_EDGE = 60.0
_OFF_ITS_THING = 60.0
_BESIDE_ITS_AREA, _ABOUT_ITS_MIDDLE = 15.0, 40.0

# Sides at which a label may stand: below first, as a name under a picture; then the corners and what lies between.
_SIDES = (
    (0.0, 1.0), (0.0, -1.0), (1.0, 0.0), (-1.0, 0.0), (1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0),
    (0.5, 1.0), (-0.5, 1.0), (0.5, -1.0), (-0.5, -1.0), (1.0, 0.5), (-1.0, 0.5), (1.0, -0.5), (-1.0, -0.5),
)  # fmt: skip
_COLUMNS, _ROWS = 7, 8
_ROW_PX = 6.0
_HALO_PX = 2.0
"""The white rim of the letters, under which lines disappear as well."""


@dataclass(frozen=True)
class Label:
    """A text that is to stand near something. All lengths are pixels, y down.

    Attributes:
        text: what is written.
        at: the middle of what it names.
        reach: half width and half height of what it names.
        outline: the area that it names; it stands inside if it fits in there. Empty: it names no area.
        colour: of the text; empty: that of all texts.
    """

    text: str
    at: Point
    reach: Point = (0.0, 0.0)
    outline: tuple[Point, ...] = ()
    colour: str = ""

    @property
    def half(self) -> Point:
        """Half width and half height of the text."""
        return len(self.text) * CHARACTER_PX / 2, LABEL_PX / 2


@dataclass(frozen=True)
class Placed:
    """A label and the middle of its text; with a line that leads to what it names, if that is not beside it."""

    label: Label
    x: float
    y: float
    leader: Segment | None

    @property
    def box(self) -> Box:
        """What the text covers: left, top, right, bottom."""
        half_x, half_y = self.label.half
        return self.x - half_x, self.y - half_y, self.x + half_x, self.y + half_y


@dataclass
class Surroundings:
    """What labels should keep off.

    Attributes:
        frame: the picture; no label leaves it.
        solids: what must not be covered: robots, balls, other texts.
        lines: thin things with what it costs to cover a pixel of them.
        bodies: outlines of things on which only their own name may stand.
    """

    frame: Box
    solids: list[Box] = field(default_factory=list)
    lines: list[tuple[Segment, float]] = field(default_factory=list)
    bodies: list[tuple[Point, ...]] = field(default_factory=list)


def place_labels(labels: Sequence[Label], around: Surroundings) -> list[Placed]:
    """Return the places of all labels, in their order."""
    board, frame = _Board(around), around.frame
    # Who names a thing is bound to its place; who names an area has more to choose from.
    order = sorted(range(len(labels)), key=lambda k: (bool(labels[k].outline), k))
    inside = [_inside(label, _smaller(label, labels), frame) for label in labels]
    placed: dict[int, Placed] = {}
    for _ in range(_PASSES if len(labels) <= _MANY_LABELS else 1):
        moved = False
        for k in order:
            label, before = labels[k], placed.get(k)
            if before is not None:
                board.take(k, before)
            placed[k] = board.best(_placed(label, *label.at, frame), inside[k], *_around(label, around))
            board.put(k, placed[k])
            moved |= placed[k] != before
        if not moved:
            break
    return [placed[k] for k in range(len(labels))]


def _placed(label: Label, x: float, y: float, frame: Box) -> Placed:
    """Return a label at a place; one that would leave the picture is moved into it."""
    half_x, half_y = label.half
    centre = (_within(x, frame[0] + half_x, frame[2] - half_x), _within(y, frame[1] + half_y, frame[3] - half_y))
    return Placed(label, *centre, _leader(label, centre))


def _smaller(label: Label, labels: Sequence[Label]) -> list[tuple[Point, ...]]:
    """Return the areas that are smaller than that of a label: its text would be taken for the name of one of them."""
    if not label.outline:
        return []
    size = _size(label.outline)
    return [other.outline for other in labels if other.outline and _size(other.outline) < size]


def _size(outline: Sequence[Point]) -> float:
    left, top, right, bottom = _bounds(outline)
    return (right - left) * (bottom - top)


def _inside(label: Label, smaller: Sequence[Sequence[Point]], frame: Box) -> list[tuple[float, Placed]]:
    """Return the places inside the area: along its upper and lower edge first, in the middle of them or in a corner.

    Each has its distance from the best one; the nearest comes first. Areas in the area are avoided.
    """
    found = []
    for far, x, y in _points_inside(label, frame):
        shared = sum(_is_inside((x, y), outline) for outline in smaller)
        found.append((far + _IN_A_SMALLER_AREA * shared, _placed(label, x, y, frame)))
    return sorted(found, key=lambda one: one[0])


def _points_inside(label: Label, frame: Box) -> Iterator[tuple[float, float, float]]:
    if not label.outline:
        return
    half_x, half_y = label.half[0] + _GAP_PX, label.half[1] + _GAP_PX
    left, top, right, bottom = _bounds(label.outline, frame)
    if right - left < 2 * half_x or bottom - top < 2 * half_y:
        return
    # Close together along both edges, wide apart between them.
    room = bottom - top - 2 * half_y
    steps = [row * _ROW_PX for row in range(_ROWS)]
    rows = [*steps, *(room - step for step in steps), *(room * part / _ROWS for part in range(1, _ROWS))]
    for y in (top + half_y + row for row in rows if 0 <= row <= room):
        for column in range(_COLUMNS):
            x = left + half_x + (right - left - 2 * half_x) * column / (_COLUMNS - 1)
            corners = ((x - half_x, y - half_y), (x + half_x, y - half_y),
                       (x - half_x, y + half_y), (x + half_x, y + half_y))  # fmt: skip
            if all(_is_inside(corner, label.outline) for corner in corners):
                to_edge = min(y - half_y - top, bottom - half_y - y)
                to_column = min(abs(x - (left + right) / 2), x - half_x - left, right - half_x - x)
                yield 0.2 * to_edge + 0.1 * to_column + 0.01 * (y - top), x, y


def _around(label: Label, around: Surroundings) -> list[Iterator[tuple[float, Placed]]]:
    """Return rows of places around what is named. Those for an area are worse than what is well inside it.

    The name of a thing rather stands on it, even across its edge, than beside it.
    """
    if not label.outline:
        return [_rings(label, label.at, label.reach, around.frame, 0.0)]
    rows = [_rings(label, label.at, label.reach, around.frame, _ABOUT_ITS_MIDDLE)]
    if label.outline not in around.bodies:
        left, top, right, bottom = _bounds(label.outline)
        middle, reach = ((left + right) / 2, (top + bottom) / 2), ((right - left) / 2, (bottom - top) / 2)
        rows.append(_rings(label, middle, reach, around.frame, _BESIDE_ITS_AREA))
    return rows


def _rings(label: Label, at: Point, reach: Point, frame: Box, far: float) -> Iterator[tuple[float, Placed]]:
    """Yield places in rings around a point, until the rings leave the picture; the nearest come first.

    Args:
        label: what is placed.
        at: the point.
        reach: half width and half height of what the rings leave free around it.
        frame: the picture.
        far: by how much they are worse than the places of another row.
    """
    (x, y), (half_x, half_y) = at, label.half
    longest = max(frame[2] - frame[0], frame[3] - frame[1])
    ring, gap = 0, _GAP_PX
    while gap < longest:
        for rank, (side_x, side_y) in enumerate(_SIDES):
            place = (x + side_x * (reach[0] + gap + half_x), y + side_y * (reach[1] + gap + half_y))
            yield far + gap + 0.2 * rank, _placed(label, *place, frame)
        ring += 1
        # Close together where it matters to be near, wide apart where it is far anyway.
        gap += _RING_PX * (1 + ring / _WIDER_AFTER)


def _leader(label: Label, centre: Point) -> Segment | None:
    """Return the line from the text to what it names; None if it stands beside it or in it."""
    if label.outline and _is_inside(centre, label.outline):
        return None
    half_x, half_y = label.half
    (x, y), (at_x, at_y) = centre, label.at
    if _edge_meets(label.outline, _grown((x - half_x, y - half_y, x + half_x, y + half_y), _LEADER_FROM_PX)):
        return None
    start = (_within(at_x, x - half_x, x + half_x), _within(at_y, y - half_y, y + half_y))
    gap_x = max(abs(at_x - start[0]) - label.reach[0], 0.0)
    gap_y = max(abs(at_y - start[1]) - label.reach[1], 0.0)
    if max(gap_x, gap_y) < _LEADER_FROM_PX:
        return None
    return start, label.at


class _Board:
    """Knows what stands where, and finds the candidate that is in the way of least."""

    def __init__(self, around: Surroundings) -> None:
        self._solids: _Grid[Box] = _Grid(around.frame)
        for k, solid in enumerate(around.solids):
            self._solids.add(k, solid, solid)
        self._lines: _Grid[tuple[Segment, float]] = _Grid(around.frame)
        for k, line in enumerate(around.lines):
            self._lines.add(k, _bounds(line[0]), line)
        self._bodies: _Grid[tuple[Point, ...]] = _Grid(around.frame)
        for k, body in enumerate(around.bodies):
            self._bodies.add(k, _bounds(body), body)
        self._things = frozenset(around.bodies)
        self._labels: _Grid[Box] = _Grid(around.frame)
        self._leaders: _Grid[Segment] = _Grid(around.frame)

    def put(self, k: int, placed: Placed) -> None:
        self._labels.add(k, placed.box, placed.box)
        if placed.leader is not None:
            self._leaders.add(k, _bounds(placed.leader), placed.leader)

    def take(self, k: int, placed: Placed) -> None:
        self._labels.remove(k, placed.box)
        if placed.leader is not None:
            self._leaders.remove(k, _bounds(placed.leader))

    def best(self, fallback: Placed, *candidates: Iterable[tuple[float, Placed]]) -> Placed:
        """Return the best of several rows of candidates; in each row the nearest come first.

        Args:
            fallback: what is returned if there is none.
            candidates: rows of distance and place.
        """
        least, chosen = float("inf"), fallback
        for row in candidates:
            waited = 0
            for far, placed in row:
                # All that follow in this row are further away still.
                if far >= least or (waited > _PATIENCE and least < _ON_A_LABEL):
                    break
                cost = self._cost(far, placed, least)
                waited += 1
                if cost < least:
                    least, chosen, waited = cost, placed, 0
        return chosen

    def _cost(self, far: float, placed: Placed, least: float) -> float:
        """Return what a place costs; once that is no less than ``least``, the rest is not looked at."""
        cost = far
        for more in self._in_the_way(placed):
            cost += more
            if cost >= least:
                break
        return cost

    def _in_the_way(self, placed: Placed) -> Iterator[float]:
        """Yield what it costs to cover each thing, what costs most first."""
        box, leader = placed.box, placed.leader
        for label in self._labels.near(box):
            shared = _shared(box, label)
            yield _ON_A_LABEL + _ON_A_LABEL_PER_PX2 * shared if shared > 0 else 0.0
        for other in self._leaders.near(box):
            yield _LEADER_OVER_LABEL if _covered(other, box) > 0 else 0.0
        for solid in self._solids.near(box):
            shared = _shared(box, solid)
            yield _ON_A_SOLID + _ON_A_SOLID_PER_PX2 * shared if shared > 0 else 0.0
        for body in self._bodies.near(box):
            yield _ON_ANOTHERS_BODY if body != placed.label.outline and _meets(box, body) else 0.0
        own = placed.label.outline
        if own in self._things:
            yield 0.0 if _is_inside((placed.x, placed.y), own) else _OFF_ITS_THING
        elif _edge_meets(own, box):
            yield _ACROSS_ITS_OWN_EDGE
        with_rim = _grown(box, _HALO_PX)
        for line, weight in self._lines.near(with_rim):
            yield _covered(line, with_rim) * weight
        if leader is not None:
            yield _LEADER
            yield from self._crossed(leader)

    def _crossed(self, leader: Segment) -> Iterator[float]:
        path = _bounds(leader)
        for label in self._labels.near(path):
            yield _LEADER_OVER_LABEL if _covered(leader, label) > 0 else 0.0
        for other in self._leaders.near(path):
            yield _LEADER_OVER_LEADER if _cross(leader, other) else 0.0
        for solid in self._solids.near(path):
            yield _LEADER_OVER_SOLID if _covered(leader, solid) > 0 else 0.0


class _Grid(Generic[_Thing]):
    """Things by the cells of the paper that they touch, so that a label is compared with its neighbours alone."""

    def __init__(self, frame: Box) -> None:
        self._cells: dict[tuple[int, int], dict[int, _Thing]] = {}
        # Labels stay in the picture: what reaches far beyond it, a zone of a kilometre, has no cells out there.
        left, top, right, bottom = (int(edge // _CELL_PX) for edge in frame)
        self._shown = left - 1, top - 1, right + 1, bottom + 1

    def add(self, k: int, box: Box, thing: _Thing) -> None:
        for cell in _cells(box, self._shown):
            self._cells.setdefault(cell, {})[k] = thing

    def remove(self, k: int, box: Box) -> None:
        for cell in _cells(box, self._shown):
            self._cells[cell].pop(k, None)

    def near(self, box: Box) -> Iterable[_Thing]:
        found: dict[int, _Thing] = {}
        for cell in _cells(box, self._shown):
            here = self._cells.get(cell)
            if here:
                found.update(here)
        return found.values()


def _cells(box: Box, shown: tuple[int, int, int, int]) -> list[tuple[int, int]]:
    # Asked for a hundred thousand times a picture, mostly of labels in one cell or two.
    left, top = int(box[0] // _CELL_PX), int(box[1] // _CELL_PX)
    right, bottom = int(box[2] // _CELL_PX), int(box[3] // _CELL_PX)
    if left == right and top == bottom:
        return [(left, top)]
    columns = range(max(left, shown[0]), min(right, shown[2]) + 1)
    rows = range(max(top, shown[1]), min(bottom, shown[3]) + 1)
    return [(column, row) for column in columns for row in rows]


def _shared(a: Box, b: Box) -> float:
    """Return the area that two boxes share, in square pixels."""
    return max(min(a[2], b[2]) - max(a[0], b[0]), 0.0) * max(min(a[3], b[3]) - max(a[1], b[1]), 0.0)


def _covered(line: Segment, box: Box) -> float:
    """Return the length of the part of a line that lies in a box (Liang and Barsky's clipping)."""
    (x, y), (end_x, end_y) = line
    if max(x, end_x) <= box[0] or min(x, end_x) >= box[2] or max(y, end_y) <= box[1] or min(y, end_y) >= box[3]:
        return 0.0
    dx, dy = end_x - x, end_y - y
    enters, leaves = 0.0, 1.0
    for step, room in ((-dx, x - box[0]), (dx, box[2] - x), (-dy, y - box[1]), (dy, box[3] - y)):
        if step == 0:
            if room < 0:
                return 0.0
        elif step < 0:
            enters = max(enters, room / step)
        else:
            leaves = min(leaves, room / step)
    return max(leaves - enters, 0.0) * math.hypot(dx, dy)


def _meets(box: Box, outline: Sequence[Point]) -> bool:
    """Return whether a text stands on a polygon: with its middle, or across its edge."""
    middle = (box[0] + box[2]) / 2, (box[1] + box[3]) / 2
    return _is_inside(middle, outline) or _edge_meets(outline, box)


def _edge_meets(outline: Sequence[Point], box: Box) -> bool:
    """Return whether the edge of a polygon runs through a box."""
    sides = zip(outline, [*outline[1:], *outline[:1]], strict=True)
    return any(_covered(side, box) > 0 for side in sides)


def _grown(box: Box, by: float) -> Box:
    """Return a box that reaches further on all sides."""
    return box[0] - by, box[1] - by, box[2] + by, box[3] + by


def _cross(a: Segment, b: Segment) -> bool:
    """Return whether two lines cross each other."""
    return side(*a, b[0]) * side(*a, b[1]) < 0 and side(*b, a[0]) * side(*b, a[1]) < 0


def _is_inside(point: Point, outline: Sequence[Point]) -> bool:
    """Return whether a point lies in a polygon: a ray from it crosses the outline an odd number of times."""
    x, y = point
    inside = False
    x2, y2 = outline[-1]
    for x1, y1 in outline:
        if (y1 > y) != (y2 > y) and x < x1 + (y - y1) / (y2 - y1) * (x2 - x1):
            inside = not inside
        x2, y2 = x1, y1
    return inside


def _bounds(points: Sequence[Point], frame: Box | None = None) -> Box:
    """Return the box around points, cut to a frame."""
    xs, ys = [x for x, _ in points], [y for _, y in points]
    box = min(xs), min(ys), max(xs), max(ys)
    if frame is None:
        return box
    return max(box[0], frame[0]), max(box[1], frame[1]), min(box[2], frame[2]), min(box[3], frame[3])


def _within(value: float, low: float, high: float) -> float:
    return min(max(value, low), high) if low <= high else (low + high) / 2
