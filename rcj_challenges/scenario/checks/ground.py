"""What cannot be on the floor: zones without an inside, goals wider than the field, bodies in walls or each other."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import dist

from rcj_challenges.geometry.polygons import Point, is_simple
from rcj_challenges.rules.places.uniform_in import UniformIn
from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.models.field import FieldModel, Obstacle, Wall
from rcj_challenges.scenario.models.places import CircleZone, HalfPlaneZone, PolygonZone, RectZone, Zone
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.outlines import TOUCHING_M, Part, disc, extent, obstacle_outline, overlap, robot_outline
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.start_poses import start_pose
from rcj_challenges.scenario.tree import Path
from rcj_challenges.scenario.walk import Issue, walk


def check_ground(scenario: Scenario) -> Iterator[Issue]:
    """Yield what cannot be on the floor."""
    yield from _shapes(scenario)
    yield from _goals(scenario.field)
    yield from _bodies(scenario)


# --- shapes -----------------------------------------------------------------------------------------------------------


def _shapes(scenario: Scenario) -> Iterator[Issue]:
    for name, zone in scenario.zones.items():
        yield from _zone(zone, ("zones", name))
    for name, gate in scenario.gates.items():
        if gate.from_m == gate.to_m:
            yield Issue("empty-shape", ("gates", name, "to_m"), "both posts are at one point")
    for name, obstacle in scenario.obstacles.items():
        if _is_a_point(obstacle):
            yield Issue("empty-shape", ("obstacles", name, "to_m"), "both ends are at one point")
    roster = Roster.of(scenario)
    for model, path in walk(scenario):
        for name in roster.expand(model.uniform_in) if isinstance(model, UniformIn) else ():
            if name in scenario.zones and not _is_bounded(scenario.zones[name]):
                message = f"zone '{name}' has no end in some direction"
                yield Issue("unbounded-zone", (*path, "uniform_in"), message, "a random point needs a bounded zone")


def _zone(zone: Zone, path: Path) -> Iterator[Issue]:
    match zone:
        case RectZone():
            for axis in "xy":
                low, high = getattr(zone, f"{axis}_min_m"), getattr(zone, f"{axis}_max_m")
                if low is not None and high is not None and low >= high:
                    message = f"{axis}_min_m {low:g} is not smaller than {axis}_max_m {high:g}"
                    yield Issue("empty-shape", (*path, f"{axis}_min_m"), message)
            if (zone.x_min_m, zone.x_max_m, zone.y_min_m, zone.y_max_m) == (None,) * 4:
                yield Issue("missing-key", path, "a rect needs at least one of x_min_m, x_max_m, y_min_m, y_max_m")
        case PolygonZone():
            if not is_simple(zone.points_m):
                message = "the outline crosses or touches itself, or has no area"
                yield Issue("empty-shape", (*path, "points_m"), message, "give its corners in order")
        case HalfPlaneZone():
            if zone.normal == (0.0, 0.0):
                yield Issue(
                    "empty-shape", (*path, "normal"), "[0, 0] has no direction", "the normal points into the zone"
                )
        case CircleZone():
            pass


def _is_a_point(obstacle: Obstacle) -> bool:
    return isinstance(obstacle, Wall) and dist(obstacle.from_m, obstacle.to_m) <= TOUCHING_M


def _is_bounded(zone: Zone) -> bool:
    if zone.inverted or isinstance(zone, HalfPlaneZone):
        return False
    limits = (zone.x_min_m, zone.x_max_m, zone.y_min_m, zone.y_max_m) if isinstance(zone, RectZone) else ()
    return None not in limits


# --- field and goals --------------------------------------------------------------------------------------------------


def _goals(field: FieldModel) -> Iterator[Issue]:
    if 2 * field.corner_cut_m >= min(field.width_m, field.length_m):
        message = f"corners cut by {field.corner_cut_m:g} leave nothing of a wall"
        yield Issue("no-room", ("field", "corner_cut_m"), message)
        return
    room = field.width_m - 2 * field.corner_cut_m
    taken: dict[str, str] = {}
    for name, goal in field.goals.items():
        path: Path = ("field", "goals", name)
        if goal.width_m > room + TOUCHING_M:
            message = f"{goal.width_m:g} is wider than the end wall between its corners, {room:g}"
            yield Issue("no-room", (*path, "width_m"), message)
        if goal.end in taken:
            yield Issue("no-room", (*path, "end"), f"'{taken[goal.end]}' stands at this end already")
        taken.setdefault(goal.end, name)


class Floor:
    """Where a body may stand: the field between its walls, and the goals."""

    def __init__(self, field: FieldModel) -> None:
        self.half_x, self.half_y = field.width_m / 2, field.length_m / 2
        self.diagonal = self.half_x + self.half_y - field.corner_cut_m
        self.goals = {1.0 if goal.end == "positive_y" else -1.0: goal for goal in field.goals.values()}

    def holds(self, parts: Sequence[Part]) -> bool:
        """Return whether a body stands on the floor without being in a wall."""
        return all(self._holds_disc(part) if part.radius_m else self._holds_corners(part.points) for part in parts)

    def _holds_corners(self, corners: tuple[Point, ...]) -> bool:
        edges = [*pairwise(corners), (corners[-1], corners[0])]
        return all(self._inside(x, y) for x, y in corners) and all(self._passes(a, b) for a, b in edges)

    def _inside(self, x: float, y: float, margin: float = 0.0) -> bool:
        reach = TOUCHING_M - margin
        on_field = (
            abs(x) <= self.half_x + reach
            and abs(y) <= self.half_y + reach
            and abs(x) + abs(y) <= self.diagonal + reach * 2**0.5
        )
        return on_field or self._in_goal(x, y, margin)

    def _in_goal(self, x: float, y: float, margin: float) -> bool:
        goal = self.goals.get(1.0 if y > 0 else -1.0)
        if goal is None:
            return False
        reach = TOUCHING_M - margin
        far = self.half_y + goal.depth_m + reach
        return abs(x) <= goal.width_m / 2 + reach and self.half_y - margin <= abs(y) <= far

    def _passes(self, a: Point, b: Point) -> bool:
        """Return whether an edge that leaves the field does so through the mouth of a goal."""
        for side in (1.0, -1.0):
            line = side * self.half_y
            if (a[1] * side - self.half_y) * (b[1] * side - self.half_y) >= -(TOUCHING_M**2):
                continue
            x = a[0] + (b[0] - a[0]) * (line - a[1]) / (b[1] - a[1])
            goal = self.goals.get(side)
            if goal is None or abs(x) > goal.width_m / 2 + TOUCHING_M:
                return False
        return True

    def _holds_disc(self, round_part: Part) -> bool:
        ((x, y),), radius = round_part.points, round_part.radius_m
        if self._inside(x, y, radius):
            return True
        goal = self.goals.get(1.0 if y > 0 else -1.0)
        if goal is None or abs(x) > goal.width_m / 2 - radius + TOUCHING_M:
            return False
        # In the mouth: between the posts, neither wholly on the field nor wholly in the goal.
        return self.half_y - radius <= abs(y) <= self.half_y + goal.depth_m - radius + TOUCHING_M


# --- bodies -----------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Body:
    """A thing on the floor.

    Attributes:
        name: its name.
        path: where the file says where it stands.
        parts: what it covers.
        fixed: whether nothing can push it.
    """

    name: str
    path: Path
    parts: tuple[Part, ...]
    fixed: bool = False


def _bodies(scenario: Scenario) -> Iterator[Issue]:
    bodies = [*_robots(scenario), *_balls(scenario), *obstacle_bodies(scenario)]
    floor = Floor(scenario.field)
    for body in bodies:
        if not body.fixed and not floor.holds(body.parts):
            x_0, x_1, y_0, y_1 = extent(body.parts)
            message = (
                f"'{body.name}' stands outside the field or in a wall: it covers x {x_0:.3f} to {x_1:.3f}, "
                f"y {y_0:.3f} to {y_1:.3f}"
            )
            help_ = f"the walls are at x = ±{floor.half_x:g}, y = ±{floor.half_y:g}"
            yield Issue("outside-field", body.path, message, help_)
    yield from _overlaps(bodies)


_MAX_NAMED = 4


def _overlaps(bodies: list[Body]) -> Iterator[Issue]:
    """Yield each body that overlaps others which stand before it in the file."""
    order = {body.name: rank for rank, body in enumerate(bodies)}
    met: dict[str, list[Body]] = {}
    for pair in _overlapping(bodies):
        first, second = sorted(pair, key=lambda one: order[one.name])
        met.setdefault(second.name, []).append(first)
    for second in bodies:
        firsts = sorted(met.get(second.name, ()), key=lambda one: order[one.name])
        if firsts:
            names = listing((f"'{first.name}'" for first in firsts), _MAX_NAMED)
            help_ = "move one of them; what comes there later is put there by a rule"
            message = f"'{second.name}' overlaps {names} at the start"
            yield Issue("overlapping-bodies", second.path, message, help_, other=firsts[0].path)


def _overlapping(bodies: list[Body]) -> Iterator[tuple[Body, Body]]:
    """Sweep along x, so that a file with thousands of bodies does not cost millions of comparisons."""
    open_: list[tuple[float, Body]] = []
    for body in sorted(bodies, key=lambda body: extent(body.parts)[0]):
        x_0, x_1, _, _ = extent(body.parts)
        open_ = [(end, other) for end, other in open_ if end > x_0]
        for _, other in open_:
            if not (body.fixed and other.fixed) and overlap(body.parts, other.parts):
                yield other, body
        open_.append((x_1, body))


def _robots(scenario: Scenario) -> Iterator[Body]:
    for name, robot in scenario.robots.items():
        kit = scenario.kits.get(robot.kit)
        if kit is not None:
            yield Body(name, ("robots", name, "start"), robot_outline(kit.chassis).at(start_pose(scenario, name)))


def _balls(scenario: Scenario) -> Iterator[Body]:
    for name, ball in scenario.balls.items():
        yield Body(name, ("balls", name, "start_m"), disc(ball.radius_m).at(start_pose(scenario, name)))


def obstacle_bodies(scenario: Scenario) -> Iterator[Body]:
    """Yield the obstacles where they stand at the start; each has one part. Walls that are points have none."""
    for name, obstacle in scenario.obstacles.items():
        if _is_a_point(obstacle):
            continue
        parts = obstacle_outline(obstacle).at(start_pose(scenario, name))
        yield Body(name, ("obstacles", name), parts, fixed=isinstance(obstacle, Wall) or not obstacle.movable)
