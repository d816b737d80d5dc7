"""What cameras recognize without a picture: robots, balls and obstacles, each with the box that is visible of it.

A box is that of the thing's corners. Where something nearer may hide a part of it, it is cut by the vertical planes
of the picture's columns, as in pictures, and the box is that of what remains. Only `math` is used: the numbers are the
same on every processor.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field

from rcj_challenges.devices.base import Eye, Rgb, Seen
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world.standing import Point, Standing
from rcj_challenges.world.world import World

Place = tuple[float, float, float, float]
"""x and y of an eye in m, and the cosine and sine of where it looks."""
Part = tuple[Sequence[Point], float, float]
"""An upright prism: its corners counter-clockwise, and its range of heights in m."""
Span = tuple[float, int, int]
"""What a column shows of something: its depth, its first row and the one after."""

_NEAR_M = 1e-3
"""What is less far ahead is taken to be so far ahead."""
_CORNERS = 24
"""Of the prisms that stand for cylinders; they are a hundredth of the radius too large at most."""


@dataclass(eq=False)
class _Thing:
    """Something in the frame of its body; number 0: a part of the field, which only hides others.

    Attributes:
        front: a way in which its front looks; None: it is round.
        radius_m: of a ball, which has no parts.
        reach_m: of its farthest point from its middle.
    """

    number: int = 0
    model: str = ""
    rgb: Rgb = (0, 0, 0)
    body: int = 0
    front: Point | None = None
    radius_m: float = 0.0
    parts: list[Part] = field(default_factory=list)
    middle: Point = (0.0, 0.0)
    reach_m: float = 0.0

    def add(self, corners: Sequence[Point], low_m: float, high_m: float) -> None:
        self.parts.append((corners, low_m, high_m))
        if not self.body:
            xs, ys = zip(*corners, strict=True)
            self.middle = (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2
        self.reach_m = max(
            math.hypot(x - self.middle[0], y - self.middle[1]) for part, _, _ in self.parts for x, y in part
        )


@dataclass(eq=False)
class _Spot:
    """A thing as a camera sees it: in its frame, and between which columns and rows, in fractions of pixels.

    ``corners`` are the columns of its corners, and of the middle of a ball.
    """

    thing: _Thing
    middle: tuple[float, float, float]
    parts: list[Part]
    depths: tuple[float, float]
    columns: tuple[float, float]
    rows: tuple[float, float]
    width_m: float
    corners: list[float]


class Recognition:
    """Recognizes what cameras see."""

    def __init__(self, scenario: Scenario, roster: Roster, world: World, standing: Standing) -> None:
        self._world = world
        self._half_length_m = scenario.field.length_m / 2
        self._robots = roster.entities[: roster.robots]
        models = {
            **dict.fromkeys(self._robots, "robot"),
            **dict.fromkeys(scenario.balls, "ball"),
            **dict.fromkeys(scenario.obstacles, "obstacle"),
        }
        self._walls: list[_Thing] = []
        things: dict[str, _Thing] = {
            name: _Thing(number, model) for number, (name, model) in enumerate(models.items(), 1)
        }
        for prism in standing.prisms:
            if not prism.thing:
                self._walls.append(_Thing())
            thing = things[prism.thing] if prism.thing else self._walls[-1]
            thing.body, thing.rgb = prism.body, _rgb(prism.colour)
            (ax, ay), (bx, by) = prism.corners[:2]
            thing.front = (1.0, 0.0) if thing.model == "robot" else (ax - bx, ay - by)
            thing.add(prism.corners, prism.low_m, prism.high_m)
        for disc in standing.discs:
            thing = things[disc.thing]
            thing.body, thing.rgb = int(world.model.geom_bodyid[disc.geom]), _rgb(disc.colour)
            x, y, _ = world.model.geom_pos[disc.geom].tolist()
            thing.add(_circle(x, y, disc.radius_m), 0.0, disc.height_m)
        for ball in standing.balls:
            thing = things[ball.thing]
            thing.body, thing.rgb = ball.body, _rgb(ball.colour)
            thing.radius_m = thing.reach_m = ball.radius_m
        self._things = list(things.values())

    def take(self, eyes: Sequence[tuple[int, Eye, Place]]) -> list[list[Seen]]:
        """Return what each eye recognizes, on the robot of this index, from its place: the nearest first."""
        poses = self._world.data.xpos.tolist(), self._world.data.xmat.tolist()
        return [self._seen(_View(eye, place, *poses), self._things[robot], abs(place[1])) for robot, eye, place in eyes]

    def _seen(self, view: _View, own: _Thing, eye_y_m: float) -> list[Seen]:
        spots = [spot for thing in self._things if thing is not own and (spot := view.spot(thing)) is not None]
        spots.sort(key=lambda spot: spot.depths)
        found = []
        for spot in spots:
            before = spots
            # The field is convex without its goals: its walls hide nothing but what is in one.
            if max(eye_y_m, abs(view.field_y_m(spot.thing)) + spot.thing.reach_m) > self._half_length_m:
                before = spots + [wall for thing in self._walls if (wall := view.spot(thing)) is not None]
            if (box := view.box(spot, [one for one in before if one is not spot])) is not None:
                found.append(view.described(spot, box))
        return found


class _View:
    """What is in sight of an eye."""

    def __init__(self, eye: Eye, place: Place, xpos: list[list[float]], xmat: list[list[float]]) -> None:
        self._eye, self._xpos, self._xmat = eye, xpos, xmat
        self._x, self._y, self._cos, self._sin = place
        self._flat = eye.fov_rad < math.pi
        self._edge = math.tan(eye.fov_rad / 2) if self._flat else math.inf
        self._pitch = 2 * self._edge / eye.width if self._flat else eye.fov_rad / eye.width
        # So near, in its own size, a thing's corners are not what is nearest of it: that is on an edge.
        self._exact_within = 0 if self._flat else 4
        self._horizon = (1 - eye.down) * eye.height

    def field_y_m(self, thing: _Thing) -> float:
        """Return the y of a thing's middle on the field."""
        mx, my = thing.middle
        return self._xpos[thing.body][1] + self._xmat[thing.body][3] * mx + self._xmat[thing.body][0] * my

    def spot(self, thing: _Thing) -> _Spot | None:
        """Return a thing as it is seen; None if it lies behind or beside the view."""
        x, y, z = self._xpos[thing.body]
        turn = self._xmat[thing.body]
        # From the frame of the body to that of the camera.
        cos, sin = turn[0] * self._cos + turn[3] * self._sin, turn[3] * self._cos - turn[0] * self._sin
        dx, dy = x - self._x, y - self._y
        ahead0, aside0 = dx * self._cos + dy * self._sin, dy * self._cos - dx * self._sin
        mx, my = thing.middle
        ahead, aside = ahead0 + cos * mx - sin * my, aside0 + sin * mx + cos * my
        reach = thing.reach_m
        if self._flat and (ahead + reach <= 0 or abs(aside) - reach > (ahead + reach) * self._edge):
            return None
        if thing.radius_m:
            return self._ball(thing, ahead, aside, z - self._eye.height_m)
        parts: list[Part] = []
        for corners, low_m, high_m in thing.parts:
            turned = [(ahead0 + cos * px - sin * py, aside0 + sin * px + cos * py) for px, py in corners]
            parts.append((turned, low_m - self._eye.height_m, high_m - self._eye.height_m))
        every = [corner for part, _, _ in parts for corner in part]
        depths = [max(_NEAR_M, a) if self._flat else math.hypot(a, b) for a, b in every]
        columns = [self._column(a, b, ahead, aside) for a, b in every]
        low, high = min(part[1] for part in parts), max(part[2] for part in parts)
        slopes = [height / depth for depth in (min(depths), max(depths)) for height in (low, high)]
        across = [b for _, b in every]
        return _Spot(
            thing, (ahead, aside, (low + high) / 2), parts, (min(depths), max(depths)), (min(columns), max(columns)),
            (self._row(max(slopes)), self._row(min(slopes))), max(across) - min(across), columns,
        )  # fmt: skip

    def _ball(self, thing: _Thing, ahead: float, aside: float, up: float) -> _Spot | None:
        radius, distance = thing.radius_m, math.hypot(ahead, aside)
        if distance <= radius:
            return None
        bearing, half = math.atan2(aside, ahead), math.asin(radius / distance)
        sides = [self._column(math.cos(bearing + by), math.sin(bearing + by), ahead, aside) for by in (half, -half)]
        # In the plane through its middle it is a circle, with two tangents.
        far2 = distance * distance - radius * radius
        root = radius * math.sqrt(far2 + up * up)
        scale = distance / max(_NEAR_M, ahead) if self._flat else 1.0
        tops = [self._row((distance * up + way * root) / far2 * scale) for way in (1, -1)]
        depth = max(_NEAR_M, ahead) if self._flat else distance
        return _Spot(
            thing, (ahead, aside, up), [], (depth - radius, depth + radius), (min(sides), max(sides)),
            (tops[0], tops[1]), 2 * radius, [*sides, self._column(ahead, aside, ahead, aside)],
        )  # fmt: skip

    def box(self, spot: _Spot, others: Sequence[_Spot]) -> tuple[int, int, int, int] | None:
        """Return what is visible of a thing among others: left, top, width, height; None: nothing."""
        left, right = _whole(*spot.columns, self._eye.width)
        top, bottom = _whole(*spot.rows, self._eye.height)
        if right <= left or bottom <= top:
            return None
        before = [one for one in others if one.depths[0] < spot.depths[1] and self._share_columns(one, spot)]
        is_high = spot.rows[0] < 0 or spot.rows[1] > self._eye.height
        is_cut = is_high or spot.columns[0] < 0 or spot.columns[1] > self._eye.width
        if before or is_cut or spot.depths[0] < self._exact_within * spot.thing.reach_m:
            columns: Iterable[int] = range(left, right)
            if self._flat and not before and not is_high:
                # The highest and the lowest row are those of corners, or where the picture ends.
                columns = sorted({min(max(int(column), left), right - 1) for column in spot.corners})
            rows = {column: self._rows_left(column, spot, before) for column in columns}
            seen = [column for column in rows if rows[column]]
            if not seen:
                return None
            left, right = seen[0], seen[-1] + 1
            top, bottom = min(rows[column][0] for column in seen), max(rows[column][-1] for column in seen) + 1
        return left, top, right - left, bottom - top

    def described(self, spot: _Spot, box: tuple[int, int, int, int]) -> Seen:
        """Return what a program gets of a thing."""
        thing, yaw_rad = spot.thing, 0.0
        if thing.front is not None:
            turn, (fx, fy) = self._xmat[thing.body], thing.front
            x, y = turn[0] * fx - turn[3] * fy, turn[3] * fx + turn[0] * fy
            yaw_rad = math.atan2(y * self._cos - x * self._sin, x * self._cos + y * self._sin)
        height_m = 2 * thing.radius_m or max(part[2] for part in spot.parts) - min(part[1] for part in spot.parts)
        return Seen(thing.number, thing.model, thing.rgb, spot.middle, yaw_rad, spot.width_m, height_m, box)

    def _column(self, ahead: float, aside: float, mid_ahead: float, mid_aside: float) -> float:
        """Return where a point lies across; in a panorama on the same side of its seam as the thing's middle."""
        if self._flat:
            return self._eye.width / 2 - aside / max(_NEAR_M, ahead) / self._pitch
        off = math.atan2(mid_ahead * aside - mid_aside * ahead, mid_ahead * ahead + mid_aside * aside)
        return self._eye.width / 2 - (math.atan2(mid_aside, mid_ahead) + off) / self._pitch

    def _row(self, slope: float) -> float:
        return self._horizon - slope / self._pitch

    def _share_columns(self, one: _Spot, other: _Spot) -> bool:
        turn = 0.0 if self._flat else math.tau / self._pitch
        return any(
            one.columns[0] + by < other.columns[1] and other.columns[0] < one.columns[1] + by
            for by in (0.0, turn, -turn)
        )

    def _rows_left(self, column: int, spot: _Spot, before: Sequence[_Spot]) -> list[int]:
        """Return rows of a column in which a thing is visible, in order: the first and the last, perhaps more."""
        hidden = [span for one in before for span in self._spans(column, one)]
        rows: list[int] = []
        for depth, first, after in self._spans(column, spot):
            nearer = [(top, end) for near, top, end in hidden if near < depth]
            free: Sequence[int] = range(first, after)
            if nearer:
                free = [row for row in free if not any(top <= row < end for top, end in nearer)]
            rows += (*free[:1], *free[-1:])
        return sorted(rows)

    def _spans(self, column: int, spot: _Spot) -> Iterator[Span]:
        """Yield what a column shows of the parts of a thing if nothing is before them."""
        across = (self._eye.width / 2 - (column + 0.5)) * self._pitch
        ahead, aside = (1.0, across) if self._flat else (math.cos(across), math.sin(across))
        if spot.thing.radius_m:
            yield from self._ball_span(spot, ahead, aside)
        for corners, low, high in spot.parts:
            enter, leave = -math.inf, math.inf
            for (ax, ay), (bx, by) in zip(corners, (*corners[1:], corners[0]), strict=True):
                nx, ny = by - ay, ax - bx  # outwards
                along, away = nx * ahead + ny * aside, nx * ax + ny * ay
                if along < 0:
                    enter = max(enter, away / along)
                elif along > 0:
                    leave = min(leave, away / along)
                elif away < 0:
                    leave = -math.inf
            if 0 < enter < leave:
                top = high / (enter if high >= 0 else leave)
                yield enter, *_whole(self._row(top), self._row(low / (enter if low <= 0 else leave)), self._eye.height)

    def _ball_span(self, spot: _Spot, ahead: float, aside: float) -> Iterator[Span]:
        x, y, up = spot.middle
        length2 = ahead * ahead + aside * aside
        along, beside = x * ahead + y * aside, x * aside - y * ahead
        # In the plane of the column it is a circle: its middle at (a, up), its radius squared rho2.
        a2, rho2 = along * along / length2, spot.thing.radius_m**2 - beside * beside / length2
        if rho2 > 0 and along > 0 and a2 > rho2:
            root, scale = math.sqrt(rho2 * (a2 + up * up - rho2)), math.sqrt(length2) / (a2 - rho2)
            slopes = [(math.sqrt(a2) * up + way * root) * scale for way in (1, -1)]
            yield along / length2, *_whole(self._row(slopes[0]), self._row(slopes[1]), self._eye.height)


def _whole(first: float, last: float, most: int) -> tuple[int, int]:
    """Return the first pixel whose middle lies between two places, and the one after the last."""
    return math.ceil(min(max(first - 0.5, 0.0), most)), math.floor(min(max(last - 0.5, -1.0), most - 1.0)) + 1


def _circle(x: float, y: float, radius_m: float) -> list[Point]:
    angles = [math.tau * number / _CORNERS for number in range(_CORNERS)]
    outer_m = radius_m / math.cos(math.pi / _CORNERS)
    return [(x + outer_m * math.cos(angle), y + outer_m * math.sin(angle)) for angle in angles]


def _rgb(digits: str) -> Rgb:
    red, green, blue = bytes.fromhex(digits[1:])
    return red, green, blue
