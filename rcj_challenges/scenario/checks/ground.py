"""What cannot be on the floor: zones without an inside, goals wider than the field, bodies in walls or each other."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import dist

from rcj_challenges.core.diagnostics import Diagnostic, issue
from rcj_challenges.geometry.polygons import is_simple
from rcj_challenges.rules.places.uniform_in import UniformIn
from rcj_challenges.scenario import codes
from rcj_challenges.scenario.errors import listing
from rcj_challenges.scenario.models.field import FieldModel, Obstacle, Wall
from rcj_challenges.scenario.models.places import CircleZone, HalfPlaneZone, PolygonZone, RectZone, Zone
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.outlines import TOUCHING_M, Floor, Part, extent, outline_of, overlap
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.rule_effects import fixed_spots
from rcj_challenges.scenario.shapes import centre_of, start_pose
from rcj_challenges.scenario.tree import Path
from rcj_challenges.scenario.walk import walk


def check_ground(scenario: Scenario) -> Iterator[Diagnostic]:
    """Yield what cannot be on the floor."""
    yield from _shapes(scenario)
    field = scenario.field
    if 2 * field.cut_m >= min(field.width_m, field.length_m):
        message = f"corners cut by {field.corner_cut_m:g} leave nothing of a wall"
        yield issue(codes.DOES_NOT_FIT, ("field", "corner_cut_m"), message)
        return
    yield from _goals(field)
    yield from _bodies(scenario)


# --- shapes -----------------------------------------------------------------------------------------------------------


def _shapes(scenario: Scenario) -> Iterator[Diagnostic]:
    for name, zone in scenario.zones.items():
        yield from _zone(zone, ("zones", name))
    yield from _moving_paint(scenario)
    for name, gate in scenario.gates.items():
        if gate.from_m == gate.to_m:
            yield issue(codes.EMPTY_SHAPE, ("gates", name, "to_m"), "both posts are at one point")
    for name, obstacle in scenario.obstacles.items():
        if _is_a_point(obstacle):
            yield issue(codes.EMPTY_SHAPE, ("obstacles", name, "to_m"), "both ends are at one point")
    roster = Roster.of(scenario)
    for model, path in walk(scenario):
        for name in roster.expand(model.uniform_in) if isinstance(model, UniformIn) else ():
            if name in scenario.zones and not _is_bounded(scenario.zones[name]):
                message = f"zone '{name}' has no end in some direction, or an anchor"
                yield issue(codes.UNBOUNDED_ZONE, (*path, "uniform_in"), message, "name a fixed, bounded zone")


def _moving_paint(scenario: Scenario) -> Iterator[Diagnostic]:
    fixed = fixed_spots(scenario)
    moving = [("spots", name) for name, spot in scenario.spots.items() if spot.drawn and name not in fixed]
    for name, zone in scenario.zones.items():
        if isinstance(zone, CircleZone) and zone.drawn and zone.anchor is not None and zone.anchor not in fixed:
            moving.append(("zones", name))
    for path in moving:
        message = "what moves is not painted on the field"
        yield issue(codes.CONFLICTING_KEYS, (*path, "drawn"), message, "leave 'drawn' out", at_key=True)


def _zone(zone: Zone, path: Path) -> Iterator[Diagnostic]:
    if isinstance(zone, RectZone):
        for axis in "xy":
            low, high = getattr(zone, f"{axis}_min_m"), getattr(zone, f"{axis}_max_m")
            if low is not None and high is not None and low >= high:
                message = f"{axis}_min_m {low:g} is not smaller than {axis}_max_m {high:g}"
                yield issue(codes.EMPTY_SHAPE, (*path, f"{axis}_min_m"), message)
    if isinstance(zone, PolygonZone) and not is_simple(zone.points_m):
        message = "the outline crosses or touches itself, or has no area"
        yield issue(codes.EMPTY_SHAPE, (*path, "points_m"), message, "give its corners in order")
    if isinstance(zone, HalfPlaneZone) and zone.normal == (0.0, 0.0):
        yield issue(codes.EMPTY_SHAPE, (*path, "normal"), "[0, 0] has no direction", "the normal points into the zone")


def _is_a_point(obstacle: Obstacle) -> bool:
    return isinstance(obstacle, Wall) and dist(obstacle.from_m, obstacle.to_m) <= TOUCHING_M


def _is_bounded(zone: Zone) -> bool:
    return centre_of(zone) is not None or (isinstance(zone, PolygonZone) and not zone.inverted)


# --- field and goals --------------------------------------------------------------------------------------------------


def _goals(field: FieldModel) -> Iterator[Diagnostic]:
    room = field.width_m - 2 * field.cut_m
    if field.goals and not field.walls:
        message = "without walls there are no goals: they are openings in end walls"
        yield issue(codes.CONFLICTING_KEYS, ("field", "walls"), message, "leave 'walls' or 'goals' out", at_key=True)
    taken: dict[str, str] = {}
    for name, goal in field.goals.items():
        path: Path = ("field", "goals", name)
        if goal.width_m > room + TOUCHING_M:
            message = f"{goal.width_m:g} is wider than the end wall between its corners, {room:g}"
            yield issue(codes.DOES_NOT_FIT, (*path, "width_m"), message)
        if goal.end in taken:
            yield issue(codes.DOES_NOT_FIT, (*path, "end"), f"'{taken[goal.end]}' stands at this end already")
        taken.setdefault(goal.end, name)


# --- bodies -----------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Body:
    """A thing on the floor."""

    name: str
    path: Path
    parts: tuple[Part, ...]
    fixed: bool


def _bodies(scenario: Scenario) -> Iterator[Diagnostic]:
    """Yield what stands outside or in a wall, and what overlaps others that stand before it in the file."""
    floor, bounds = Floor(scenario.field), scenario.field.bounds
    before: list[tuple[Body, tuple[float, float, float, float]]] = []
    for body in bodies_at_start(scenario):
        x_0, x_1, y_0, y_1 = extent(body.parts)
        if not body.fixed and not floor.holds(body.parts):
            message = (
                f"'{body.name}' stands outside the field or in a wall: it covers x {x_0:.3f} to {x_1:.3f}, "
                f"y {y_0:.3f} to {y_1:.3f}"
            )
            help_ = f"the floor ends at x = ±{bounds.width_m / 2:g}, y = ±{bounds.length_m / 2:g}"
            yield issue(codes.OUTSIDE_FIELD, body.path, message, help_)
        near = (
            other
            for other, (left, right, low, high) in before
            if left < x_1 and x_0 < right and low < y_1 and y_0 < high
        )
        met = [one for one in near if not (body.fixed and one.fixed) and overlap(one.parts, body.parts)]
        before.append((body, (x_0, x_1, y_0, y_1)))
        if met:
            names = listing((f"'{other.name}'" for other in met), 4)
            help_ = "move one of them; what comes there later is put there by a rule"
            message = f"'{body.name}' overlaps {names} at the start"
            yield issue(codes.OVERLAPPING_BODIES, body.path, message, help_, other=met[0].path)


def bodies_at_start(scenario: Scenario) -> Iterator[Body]:
    """Yield what stands on the floor at the start, but robots without a kit and walls that are points."""
    paths: dict[str, Path] = {
        name: ("robots", name, "start") for name, robot in scenario.robots.items() if robot.kit in scenario.kits
    }
    paths |= {name: ("balls", name, "start_m") for name in scenario.balls}
    paths |= {name: ("obstacles", name) for name, obstacle in scenario.obstacles.items() if not _is_a_point(obstacle)}
    for name, path in paths.items():
        obstacle = scenario.obstacles.get(name)
        is_fixed = obstacle is not None and (isinstance(obstacle, Wall) or not obstacle.movable)
        yield Body(name, path, outline_of(scenario, name).at(start_pose(scenario, name)), is_fixed)
