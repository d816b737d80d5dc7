"""What cameras see: pictures by casting columns, without a graphics card (ADR 17).

All that stands on the field is an upright prism or a sphere, and cameras look level, so each column of a picture is a
vertical plane: a prism covers a range of its rows, given by where the plane enters and leaves it. The floor is looked
up in a map. Only sums, products, quotients, square roots and comparisons of single numbers are used, which are the
same on every processor; sines and cosines come from the poses.

Wheels are not drawn: like sonar and lidar, cameras see the bodies that carry them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import groupby, pairwise

import numpy as np
from numpy.typing import NDArray

from rcj_challenges.devices.base import Eye, Seen
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.shapes import SPOT_M, at_start, floor_of, floor_outline, goal_floor
from rcj_challenges.world.build_field import WALL_THICKNESS_M
from rcj_challenges.world.recognition import Recognition
from rcj_challenges.world.standing import WALL_COLOUR, Point, Prism, colour_digits, things_on_field
from rcj_challenges.world.world import World

BEYOND, FLOOR, LINE, WALL = range(4)
_COLOURS = {BEYOND: "#101418", FLOOR: "#2e8054", LINE: "#ffffff", WALL: WALL_COLOUR}

CELL_M = 0.004
"""Edge of a cell of the floor's map."""
LINE_M = 0.008
"""Width of the lines on the floor, as in videos."""
_REACH_M = 100.0
"""Things that are parked are farther away."""


class CameraRenderer:
    """Takes the pictures of all cameras of a half."""

    def __init__(self, scenario: Scenario, roster: Roster, world: World) -> None:
        self._world = world
        self._colours: list[str] = [_COLOURS[number] for number in range(4)]
        standing = things_on_field(scenario, roster, world)
        self._prisms = _Prisms(standing.prisms, world, roster.entities[: roster.robots], self.number_of)
        self._discs = [(one, self.number_of(one.colour)) for one in standing.discs]
        self._balls = [(one, self.number_of(one.colour)) for one in standing.balls]
        self._floor = _FloorMap(scenario, self.number_of)
        self._recognition = Recognition(scenario, roster, world, standing)

    @property
    def palette(self) -> list[tuple[int, int, int]]:
        """Red, green and blue of each number that stands in pictures."""
        return [tuple(bytes.fromhex(colour[1:])) for colour in self._colours]  # type: ignore[misc]

    def take(self, eyes: Sequence[tuple[int, Eye]]) -> list[bytes]:
        """Return a picture from each eye, on the robot of this index: a number of the palette per pixel, row by row.

        All eyes have the same lens.
        """
        lens = _lens(*eyes[0][1].lens)
        views = _Views(lens, [self._place(robot, eye) for robot, eye in eyes], [robot for robot, _ in eyes])
        picture = self._floor.picture(views)
        _paint(picture, [self._prisms.spans(views), *self._disc_spans(views), *self._ball_spans(views)])
        apart = np.ascontiguousarray(picture.reshape(len(picture), len(eyes), -1).transpose(1, 0, 2))
        return [one.tobytes() for one in apart]

    def recognize(self, eyes: Sequence[tuple[int, Eye]]) -> list[list[Seen]]:
        """Return what each eye recognizes, on the robot of this index: the nearest first."""
        return self._recognition.take([(robot, eye, self._place(robot, eye)) for robot, eye in eyes])

    def brightness(self, x_m: float, y_m: float) -> float:
        """Return the brightness of the floor at a place, from 0 to 1."""
        r, g, b = self.palette[self._floor.colour_at(x_m, y_m)]
        return (0.299 * r + 0.587 * g + 0.114 * b) / 255

    def _place(self, robot: int, eye: Eye) -> tuple[float, float, float, float]:
        """Return x, y, and the cosine and sine of where an eye looks."""
        data = self._world.data
        body = self._world.tables.bodies[robot]
        x, y, _ = data.xpos[body].tolist()
        cos, sin = float(data.xmat[body, 0]), float(data.xmat[body, 3])
        c, s = math.cos(eye.bearing_rad), math.sin(eye.bearing_rad)
        ahead, aside = cos * c - sin * s, sin * c + cos * s
        return x + eye.ahead_m * ahead, y + eye.ahead_m * aside, ahead, aside

    def number_of(self, colour: str) -> int:
        """Return the number of a scenario's colour in pictures."""
        digits = colour_digits(colour)
        if digits not in self._colours:
            self._colours.append(digits)
        return self._colours.index(digits)

    def _disc_spans(self, views: _Views) -> Iterable[_Spans]:
        for disc, colour in self._discs:
            x, y, _ = self._world.data.geom_xpos[disc.geom].tolist()
            along, squared = views.towards(x, y)
            inside = disc.radius_m * disc.radius_m * views.lens.squared_all(views.count) - squared
            half = np.sqrt(np.maximum(inside, 0.0))
            lengths = views.lens.squared_all(views.count)
            enter = np.where(inside > 0.0, (along - half) / lengths, np.inf)
            leave = np.where(inside > 0.0, (along + half) / lengths, -np.inf)
            yield _Spans.of(views, enter[None], leave[None], [0.0], [disc.height_m], [colour])

    def _ball_spans(self, views: _Views) -> Iterable[_Spans]:
        eye_m, lengths = views.lens.height_m, views.lens.squared_all(views.count)
        for ball, colour in self._balls:
            x, y, z = self._world.data.xpos[ball.body].tolist()
            along, squared = views.towards(x, y)
            # In the plane of a column the ball is a circle: its middle at (a, up), its radius squared rho2.
            a = along / np.sqrt(lengths)
            rho2 = ball.radius_m * ball.radius_m - squared / lengths
            up = z - eye_m
            far2 = a * a - rho2
            visible = (rho2 > 0.0) & (a > 0.0) & (far2 > 0.0)
            root = np.sqrt(np.maximum(rho2 * (a * a + up * up - rho2), 0.0))
            scale = np.sqrt(lengths) / np.where(visible, far2, 1.0)
            enter = np.where(visible, along / lengths, np.inf)
            first, after = views.rows((a * up - root) * scale, (a * up + root) * scale)
            yield _Spans(enter[None], first[None], after[None], np.array([colour], np.uint8))


@dataclass(frozen=True, eq=False)
class _Lens:
    """The rays of a picture, for an eye that looks along +x.

    Attributes:
        ahead, aside: [columns], the horizontal way of a column's rays per unit of depth.
        slopes: [rows], how much the rays of a row rise per unit of depth; falling from row to row.
        horizon_rows: rows above the horizon.
        pitch: what a row is in `slopes`.
        height_m: of the eye above the floor.
    """

    ahead: NDArray[np.float64]
    aside: NDArray[np.float64]
    slopes: NDArray[np.float64]
    horizon_rows: float
    pitch: float
    height_m: float

    def squared_all(self, count: int) -> NDArray[np.float64]:
        """Return the squared lengths of the ways of all columns of so many pictures."""
        return np.tile(self.ahead * self.ahead + self.aside * self.aside, count)


@cache
def _lens(width: int, height: int, fov_rad: float, down: float, height_m: float) -> _Lens:
    """Return the lens of `Eye.lens`; the same one each time."""
    if fov_rad < math.pi:
        edge = math.tan(fov_rad / 2)
        aside = [edge * (1 - 2 * (column + 0.5) / width) for column in range(width)]
        ahead, pitch = [1.0] * width, 2 * edge / width
    else:
        angles = [fov_rad * (0.5 - (column + 0.5) / width) for column in range(width)]
        ahead, aside = [math.cos(angle) for angle in angles], [math.sin(angle) for angle in angles]
        pitch = fov_rad / width
    above = (1 - down) * height
    slopes = [(above - (row + 0.5)) * pitch for row in range(height)]
    return _Lens(np.array(ahead), np.array(aside), np.array(slopes), above, pitch, height_m)


class _Views:
    """The columns of several pictures side by side.

    Attributes:
        x, y: [pictures], of the eyes in m.
        along_x, along_y: [pictures * columns], the ways of the rays in the frame of the field.
    """

    def __init__(self, lens: _Lens, places: Sequence[tuple[float, float, float, float]], robots: Sequence[int]) -> None:
        self.lens, self.robots, self.count = lens, robots, len(places)
        x, y, cos, sin = (np.array(numbers)[:, None] for numbers in zip(*places, strict=True))
        self.x, self.y, self.cos, self.sin = x, y, cos, sin
        self.along_x = (cos * lens.ahead - sin * lens.aside).ravel()
        self.along_y = (sin * lens.ahead + cos * lens.aside).ravel()
        self.columns = len(lens.ahead)

    def towards(self, x_m: float, y_m: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the distance of a point along each way, times the way's squared length, and beside it, squared."""
        dx = np.repeat(x_m - self.x, self.columns)
        dy = np.repeat(y_m - self.y, self.columns)
        beside = dx * self.along_y - dy * self.along_x
        return dx * self.along_x + dy * self.along_y, beside * beside

    def rows(self, low: NDArray[np.float64], high: NDArray[np.float64]) -> tuple[NDArray[np.int16], NDArray[np.int16]]:
        """Return the first row, and the one after the last, whose middles lie between two slopes."""
        lens = self.lens
        most = float(len(lens.slopes))
        middle = lens.horizon_rows - 0.5
        first = np.ceil(np.minimum(np.maximum(middle - high / lens.pitch, 0.0), most))
        after = np.floor(np.minimum(np.maximum(middle - low / lens.pitch, -1.0), most)) + 1
        return first.astype(np.int16), after.astype(np.int16)


@dataclass(frozen=True)
class _Spans:
    """What things cover of each column: [things, columns] depth (``inf``: nothing), first row and the one after."""

    depths: NDArray[np.float64]
    first: NDArray[np.int16]
    after: NDArray[np.int16]
    colours: NDArray[np.uint8]

    @classmethod
    def of(
        cls, views: _Views, enter: NDArray[np.float64], leave: NDArray[np.float64],
        low_m: Sequence[float] | NDArray[np.float64], high_m: Sequence[float] | NDArray[np.float64],
        colours: Sequence[int] | NDArray[np.uint8],
    ) -> _Spans:  # fmt: skip
        """Return the spans of prisms, by where the planes of the columns enter and leave them."""
        hit = (enter < leave) & (enter > 0.0) & (enter < _REACH_M)
        near, far = np.where(hit, enter, 1.0), np.where(hit, leave, 1.0)
        low, high = (np.asarray(heights)[:, None] - views.lens.height_m for heights in (low_m, high_m))
        first, after = views.rows(low / np.where(low <= 0.0, near, far), high / np.where(high >= 0.0, near, far))
        return cls(np.where(hit, enter, np.inf), first, after, np.asarray(colours, np.uint8))


class _Prisms:
    """All prisms, their edges side by side."""

    def __init__(
        self, prisms: Sequence[Prism], world: World, robots: Sequence[str], number_of: Callable[[str], int]
    ) -> None:
        self._world = world
        prisms = sorted(prisms, key=lambda one: len(one.corners))
        edges = [(one.body, *edge) for one in prisms for edge in _edges(one.corners)]
        self._body = np.array([body for body, *_ in edges])
        self._x, self._y, self._nx, self._ny = (np.array([edge[n] for edge in edges]) for n in (1, 2, 3, 4))
        # How many prisms with how many corners follow each other.
        self._groups = [
            (len(list(group)), corners) for corners, group in groupby(prisms, key=lambda one: len(one.corners))
        ]
        self._low = np.array([one.low_m for one in prisms])
        self._high = np.array([one.high_m for one in prisms])
        self._colours = np.array([number_of(one.colour) for one in prisms], np.uint8)
        self._prisms_of = [[number for number, one in enumerate(prisms) if one.thing == name] for name in robots]

    def spans(self, views: _Views) -> _Spans:
        """Return the spans that they cover; an eye does not see its own robot."""
        data = self._world.data
        body = self._body
        x0, y0, cos, sin = data.xpos[body, 0], data.xpos[body, 1], data.xmat[body, 0], data.xmat[body, 3]
        x, y = x0 + cos * self._x - sin * self._y, y0 + sin * self._x + cos * self._y
        nx, ny = cos * self._nx - sin * self._ny, sin * self._nx + cos * self._ny
        along = nx[:, None] * views.along_x + ny[:, None] * views.along_y
        away = (nx * x + ny * y)[:, None] - (nx[:, None] * views.x[:, 0] + ny[:, None] * views.y[:, 0])
        with np.errstate(divide="ignore", invalid="ignore"):
            depth = (away[:, :, None] / along.reshape(len(along), views.count, -1)).reshape(along.shape)
        enters = along < 0.0
        enter = self._each(np.maximum, np.where(enters, depth, -np.inf))
        leave = self._each(np.minimum, np.where(enters, np.inf, depth))
        for number, robot in enumerate(views.robots):
            enter[self._prisms_of[robot], number * views.columns : (number + 1) * views.columns] = np.inf
        return _Spans.of(views, enter, leave, self._low, self._high, self._colours)

    def _each(self, better: np.ufunc, depths: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the best depth of each prism from those of its edges."""
        found, at = [], 0
        for prisms, corners in self._groups:
            edges = depths[at : at + prisms * corners].reshape(prisms, corners, -1)
            found.append(better.reduce(edges, axis=1))
            at += prisms * corners
        return np.concatenate(found)


def _edges(corners: Sequence[Point]) -> Iterable[tuple[float, float, float, float]]:
    """Yield a point of each edge of a polygon and its normal, outwards; corners run counter-clockwise."""
    for (ax, ay), (bx, by) in zip(corners, (*corners[1:], corners[0]), strict=True):
        yield ax, ay, by - ay, ax - bx


def _paint(picture: NDArray[np.uint8], parts: Sequence[_Spans]) -> None:
    """Paint what stands on the floor, in each column the nearest first, each only over floor and background."""
    depths = np.concatenate([part.depths for part in parts])
    first = np.concatenate([part.first for part in parts])
    after = np.concatenate([part.after for part in parts])
    colours = np.concatenate([part.colours for part in parts])
    rows = np.arange(len(picture), dtype=np.int16)[:, None]
    columns = np.arange(picture.shape[1])
    free = np.ones(picture.shape, np.bool_)
    while True:
        nearest = depths.argmin(axis=0)
        seen = depths[nearest, columns] < np.inf
        if not seen.any():
            return
        covers = (rows >= first[nearest, columns]) & (rows < after[nearest, columns]) & seen & free
        np.copyto(picture, colours[nearest], where=covers)
        free &= ~covers
        depths[nearest, columns] = np.inf


class _FloorMap:
    """The colours of the floor, in cells."""

    def __init__(self, scenario: Scenario, number_of: Callable[[str], int]) -> None:
        field = scenario.field
        depth_m = max([goal.depth_m for goal in field.goals.values()], default=0.0) + WALL_THICKNESS_M
        floor = field.bounds
        self._x0, self._y0 = -floor.width_m / 2 - WALL_THICKNESS_M, -floor.length_m / 2 - depth_m
        self._x, self._y = (self._x0 + _cells(-2 * self._x0))[:, None], self._y0 + _cells(-2 * self._y0)
        self._cells = np.full((len(self._x), len(self._y)), FLOOR, np.uint8)
        for goal in field.goals.values():
            corners = goal_floor(goal, field)
            west, east = sorted({x for x, _ in corners})
            south, north = sorted({y for _, y in corners})
            inside = (self._x > west) & (self._x < east) & (self._y > south) & (self._y < north)
            self._cells[inside] = number_of(_darker(goal.colour))
            self._draw(corners[:2], LINE)
        if field.goals:
            self._draw([(-field.width_m / 2, 0.0), (field.width_m / 2, 0.0)], LINE)
        self._draw([*floor_of(field), floor_of(field)[0]], LINE)
        for zone in scenario.zones.values():
            if zone.drawn and (outline := floor_outline(at_start(zone, scenario), floor)):
                self._draw([*outline, outline[0]], LINE if zone.colour is None else number_of(zone.colour))
        for spot in (spot for spot in scenario.spots.values() if spot.drawn):
            at = (spot.x_m, spot.y_m)
            self._draw([at, at], LINE if spot.colour is None else number_of(spot.colour), 2 * SPOT_M)
        self._ways: dict[_Lens, tuple[NDArray[np.float64], NDArray[np.float64], int]] = {}

    def _draw(self, points: Sequence[Point], colour: int, width_m: float = LINE_M) -> None:
        for (ax, ay), (bx, by) in pairwise(points):
            dx, dy = bx - ax, by - ay
            length2 = dx * dx + dy * dy or 1.0
            # Only the cells around it: a field of 10 m has 6 million, and a circle 72 lines.
            column = slice(*np.searchsorted(self._x[:, 0], (min(ax, bx) - width_m, max(ax, bx) + width_m)))
            row = slice(*np.searchsorted(self._y, (min(ay, by) - width_m, max(ay, by) + width_m)))
            x, y = self._x[column], self._y[row]
            share = np.clip(((x - ax) * dx + (y - ay) * dy) / length2, 0.0, 1.0)
            off_x, off_y = x - ax - share * dx, y - ay - share * dy
            self._cells[column, row][off_x * off_x + off_y * off_y <= width_m * width_m / 4] = colour

    def colour_at(self, x_m: float, y_m: float) -> int:
        """Return the number of the colour at a place; outside of the field that of its edge."""
        last_x, last_y = self._cells.shape[0] - 1, self._cells.shape[1] - 1
        i = min(max((x_m - self._x0) / CELL_M, 0.0), last_x)
        j = min(max((y_m - self._y0) / CELL_M, 0.0), last_y)
        return int(self._cells[int(i), int(j)])

    def picture(self, views: _Views) -> NDArray[np.uint8]:
        """Return pictures of an empty floor."""
        lens = views.lens
        if lens not in self._ways:
            below = lens.slopes[lens.slopes < 0.0]
            depths = (lens.height_m / -below)[:, None, None]
            self._ways[lens] = depths * lens.ahead, depths * lens.aside, len(lens.slopes) - len(below)
        ahead, aside, above = self._ways[lens]
        # [rows, pictures, columns]
        x = (views.x + views.cos * ahead - views.sin * aside - self._x0) / CELL_M
        y = (views.y + views.sin * ahead + views.cos * aside - self._y0) / CELL_M
        last_x, last_y = self._cells.shape[0] - 1, self._cells.shape[1] - 1
        i = np.minimum(np.maximum(x, 0.0), last_x).astype(np.intp)
        j = np.minimum(np.maximum(y, 0.0), last_y).astype(np.intp)
        picture = np.full((len(lens.slopes), views.count * views.columns), BEYOND, np.uint8)
        picture[above:] = self._cells.take(i * (last_y + 1) + j).reshape(len(i), -1)
        return picture


def _cells(extent_m: float) -> NDArray[np.float64]:
    """Return the middles of the cells along an extent."""
    return np.array([(cell + 0.5) * CELL_M for cell in range(math.ceil(extent_m / CELL_M))])


def _darker(colour: str) -> str:
    parts = bytes.fromhex(colour_digits(colour)[1:])
    return "#" + bytes(part * 7 // 10 for part in parts).hex()
