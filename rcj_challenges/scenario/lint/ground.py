"""Lint of the floor: places off the field, entities that never stand on it, layouts that cannot find room."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rcj_challenges.scenario.checks.ground import Body, Floor, obstacle_bodies
from rcj_challenges.scenario.floor import Corners, floor_parts, on_floor
from rcj_challenges.scenario.floor_shapes import (
    corners_of,
    points_in,
    segment_has_floor,
    share_in,
    zone_has_floor,
)
from rcj_challenges.scenario.lint.suspect import Subject, Suspect, on_field
from rcj_challenges.scenario.models import places
from rcj_challenges.scenario.models.actions import Place, Remove, SetSpot
from rcj_challenges.scenario.models.conditions import Distance
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.models.state import DistanceValue
from rcj_challenges.scenario.models.triggers import Enters, HalfStarted, Leaves
from rcj_challenges.scenario.outlines import Part, disc, overlap, robot_outline
from rcj_challenges.scenario.polygons import Point
from rcj_challenges.scenario.remembered import fixed_spots
from rcj_challenges.scenario.tree import Path

_LINE_SAMPLES = 65
_INSIDE_SHARE = 0.6
"""More than half: a post that rounds the end of a wall is half in it, and walls may cross or meet at corners."""
_NO_SHARE = 1e-9
_FAR_BEYOND_M = 0.5
"""A zone a little larger than the floor catches what jumps over a wall; one that is so much larger is a slip."""


def check_places(subject: Subject) -> Iterator[Suspect]:
    """Zones, gates and spots without a point on the field."""
    scenario = subject.scenario
    parts = floor_parts(scenario.field)
    measured = _only_measured(subject)
    for name, zone in scenario.zones.items():
        if name not in measured and not zone_has_floor(zone, parts):
            yield _off_field("zone", ("zones", name), f"zone '{name}' has no point on the field: nothing enters it")
    yield from _covering(subject)
    for name, gate in scenario.gates.items():
        moves = gate.anchor is not None
        if not moves and name not in measured and not segment_has_floor(gate.from_m, gate.to_m, parts):
            yield _off_field("gate", ("gates", name), f"gate '{name}' has no point on the field: nothing crosses it")
    for name, spot in fixed_spots(scenario).items():
        if not on_floor((spot.x_m, spot.y_m), parts):
            yield _off_field("spot", ("spots", name), f"spot '{name}' is off the field: nothing can be put there")
    for model, path in subject.models:
        line = model.to if isinstance(model, SetSpot) else None
        if isinstance(line, places.OnLine) and not segment_has_floor(*line.on_line, parts):
            reason = "no point of the line is on the field: the spot stays where it is"
            yield Suspect("spot_off_the_field", (*path, "to"), reason, "correct its numbers")


def _covering(subject: Subject) -> Iterator[Suspect]:
    """Zones that cover the floor by far, of which a rule waits that something enters or leaves them."""
    scenario = subject.scenario
    edges = (one for _, rule in subject.standing() for one in rule.triggers if isinstance(one, Enters | Leaves))
    awaited = {name for edge in edges for name in subject.roster.expand(edge.zone)} & scenario.zones.keys()
    field, more_m = scenario.field, 2 * _FAR_BEYOND_M
    beyond = {"width_m": field.width_m + more_m, "length_m": field.length_m + more_m, "corner_cut_m": 0.0}
    parts = floor_parts(field.model_copy(update=beyond))
    for name in (name for name in scenario.zones if name in awaited):
        zone = scenario.zones[name]
        if not zone_has_floor(zone.model_copy(update={"inverted": not zone.inverted}), parts):
            problem = f"zone '{name}' covers the whole floor and half a metre more: nothing ever enters or leaves it"
            remedy = "correct its numbers: lengths are in m"
            yield Suspect("zone_covers_the_floor", ("zones", name), problem, remedy, at_key=True)


def _only_measured(subject: Subject) -> frozenset[str]:
    """Return what rules only measure distances to: that may lie in a wall or behind it."""
    measured: set[str] = set()
    met: set[str] = set()
    for use in filter(on_field, subject.uses):
        if use.model is Rule:
            continue  # whom a rule is for is met where it says `each`
        names = (
            subject.members(use.name, subject.scenario.rules[str(use.path[1])])
            if use.path[0] == "rules"
            else subject.roster.expand(use.name)
        )
        (measured if issubclass(use.model, Distance | DistanceValue) else met).update(names)
    return frozenset(measured - met)


def _off_field(noun: str, path: Path, reason: str) -> Suspect:
    return Suspect(f"{noun}_off_the_field", path, reason, "correct its numbers, or remove it", at_key=True)


def check_obstacles(subject: Subject) -> Iterator[Suspect]:
    """Fixed obstacles that are wholly off the field, or for the most part inside each other."""
    floor = floor_parts(subject.scenario.field)
    before: list[Body] = []
    for body in obstacle_bodies(subject.scenario):
        if not body.fixed:
            continue
        if all(_share(body, part) < _NO_SHARE for part in floor):
            yield _off_field("obstacle", body.path, f"obstacle '{body.name}' is wholly off the field: nothing meets it")
        other = next((one for one in before if _are_one_in_the_other(one, body)), None)
        if other is not None:
            yield Suspect(
                "obstacles_in_each_other",
                body.path,
                f"fixed obstacles '{other.name}' and '{body.name}' stand inside each other",
                "move one of them, or remove it",
                at_key=True,
            )
        before.append(body)


def _are_one_in_the_other(first: Body, second: Body) -> bool:
    if not overlap(first.parts, second.parts):
        return False
    return any(
        _share(one, corners_of(other.parts[0])) > _INSIDE_SHARE for one, other in ((first, second), (second, first))
    )


def _share(obstacle: Body, window: Corners) -> float:
    return share_in(corners_of(obstacle.parts[0]), window)  # an obstacle has one part


def check_entities(subject: Subject) -> Iterator[Suspect]:
    """Robots that nobody drives; entities that are taken off at the start and never come back."""
    scenario = subject.scenario
    driven = {robot for entrant in scenario.entrants.values() for robot in entrant.robots}
    for name, robot in scenario.robots.items():
        if name not in driven and not robot.idle:
            yield Suspect(
                "robot_without_program",
                ("robots", name),
                f"no entrant drives '{name}', and it is not idle",
                "name it under entrants:, write idle: true for an obstacle, or remove it by null",
                at_key=True,
            )
    back = _brought_back(subject)
    for name, rule in subject.standing():
        if rule.conditions or not any(isinstance(trigger, HalfStarted) for trigger in rule.triggers):
            continue
        for index, action in enumerate(rule.actions):
            if not isinstance(action, Remove) or action.for_s is not None:
                continue
            gone = sorted(subject.members(action.entity, rule) - back)
            if gone:
                yield Suspect(
                    "entity_never_on_the_field",
                    ("rules", name, "actions", index),
                    f"'{gone[0]}' is taken off at the start and no rule ever places it",
                    "place it in a rule, give for_s, or remove the entity by null",
                )


def _brought_back(subject: Subject) -> frozenset[str]:
    placed: set[str] = set()
    for _, rule in subject.standing():
        for action in rule.actions:
            if isinstance(action, Place) and action.entity is not None:
                placed |= subject.members(action.entity, rule)
    for layout in subject.scenario.placements.values():
        for placing in layout:
            placed.update(subject.roster.expand(placing.entity))
    return frozenset(placed)


# --- room -------------------------------------------------------------------------------------------------------------


def check_layouts(subject: Subject) -> Iterator[Suspect]:
    """Placements that can find no room, wherever chance puts them."""
    room = _Room(subject)
    for name, layout in subject.scenario.placements.items():
        yield from room.check([(placing, ("placements", name, i)) for i, placing in enumerate(layout)])
    for model, path in subject.models:
        if isinstance(model, Place) and model.at is not None and model.entity is not None:
            yield from room.check([(model, path)])


_Parts = tuple[Part, ...]


class _Room:
    """Where things may stand beside what certainly stands there."""

    def __init__(self, subject: Subject) -> None:
        self._subject = subject
        self._scenario = subject.scenario
        self._floor = Floor(self._scenario.field)
        self._fixed = [body.parts for body in obstacle_bodies(self._scenario) if body.fixed]
        self._spots = {name: (spot.x_m, spot.y_m) for name, spot in fixed_spots(self._scenario).items()}

    def check(self, placings: Sequence[tuple[places.Placing | Place, Path]]) -> Iterator[Suspect]:
        """Put one thing after the other where it certainly goes, and yield those that fit nowhere."""
        standing: list[tuple[str, _Parts]] = []
        for placing, path in placings:
            names = self._names(placing)
            found = self._points(placing)
            if found is None or not names:
                continue
            if 1 < len(found) < len(names) and _is_spots(placing):
                yield no_room(path, f"{len(names)} things cannot share {len(found)} spots", _REMEDY, placing)
                continue
            for name in names:
                standing = [entry for entry in standing if entry[0] != name]
                problem = self._try(name, placing, found, standing)
                if problem is not None:
                    yield no_room(path, problem, _REMEDY, placing)
                    break
                if len(found) == 1:
                    standing.append((name, self._parts(name, found[0], placing)))

    def _names(self, placing: places.Placing | Place) -> tuple[str, ...]:
        names = placing.entity
        if names is None or names == "each":
            return ()
        known = self._subject.roster.index
        return tuple(name for name in self._subject.roster.expand(names) if name in known)

    def _points(self, placing: places.Placing | Place) -> list[Point] | None:
        """Return where a placement may put things; None if that cannot be told from the file."""
        if placing.noise_m != (0.0, 0.0) or (placing.mirror is not None and placing.mirror.when is not None):
            return None
        points = self._unmirrored(placing.at)
        if points is None or placing.mirror is None:
            return points
        axis = placing.mirror.axis
        return [(-x if axis in ("x", "both") else x, -y if axis in ("y", "both") else y) for x, y in points]

    def _unmirrored(self, at: places.At | None) -> list[Point] | None:
        scenario = self._scenario
        found: list[Point] | None = None
        match at:
            case places.AtPoint():
                found = [at.point]
            case places.AtSpot() if at.spot in self._spots:
                found = [self._spots[at.spot]]
            case places.UniformIn():
                zones = self._subject.roster.expand(at.uniform_in)
                found = [point for name in zones for point in points_in(scenario.zones[name])]
            case places.OnLine():
                (ax, ay), (bx, by) = at.on_line
                shares = [i / (_LINE_SAMPLES - 1) for i in range(_LINE_SAMPLES)]
                found = [(ax + share * (bx - ax), ay + share * (by - ay)) for share in shares]
            case places.Choice():
                names = [name for option in at.choice if isinstance(option, str) for name in self._expand(option)]
                if self._spots.keys() >= set(names):
                    points = [option for option in at.choice if isinstance(option, tuple)]
                    found = [*points, *(self._spots[name] for name in names)]
            case places.NearestFree(nearest_free=spots) | places.FurthestFree(furthest_free=spots):
                names = list(self._subject.roster.expand(spots))
                if self._spots.keys() >= set(names):
                    found = [self._spots[name] for name in names]
        return found

    def _expand(self, name: str) -> tuple[str, ...]:
        return self._subject.roster.expand(name)

    def _try(
        self, name: str, placing: places.Placing | Place, points: list[Point], standing: list[tuple[str, _Parts]]
    ) -> str | None:
        """Return why a thing fits on none of these points, or None if it fits on one."""
        in_wall, on_whom = 0, ""
        for point in points:
            parts = self._parts(name, point, placing)
            if not self._floor.holds(parts) or any(overlap(parts, fixed) for fixed in self._fixed):
                in_wall += 1
                continue
            on_whom = next((other for other, there in standing if overlap(parts, there)), "")
            if not on_whom:
                return None
        if in_wall == len(points):
            return f"'{name}' would stand in a wall or an obstacle, or off the field"
        what = "action" if isinstance(placing, Place) else "layout"
        return f"'{name}' would stand on '{on_whom}', which this {what} places before it"

    def _parts(self, name: str, point: Point, placing: places.Placing | Place) -> _Parts:
        """Return what a thing covers at a point; of a robot that may look anywhere what it covers in any case."""
        scenario = self._scenario
        if name in scenario.balls:
            return disc(scenario.balls[name].radius_m).at((*point, 0.0))
        robot = scenario.robots.get(name)
        if robot is None:  # a movable obstacle keeps its own form; its smallest extent is enough here
            return disc(0.005).at((*point, 0.0))
        chassis = scenario.kits[robot.kit].chassis
        yaw = robot.start.yaw_rad if placing.facing == "start" else placing.facing
        if not isinstance(yaw, int | float):
            return disc(chassis.size_m / 2).at((*point, 0.0))
        return robot_outline(chassis).at((*point, yaw))  # mirroring moves a robot and does not turn it


def _is_spots(placing: places.Placing | Place) -> bool:
    return isinstance(placing.at, places.NearestFree | places.FurthestFree | places.Choice)


_REMEDY = "correct the place, or make it larger"


def no_room(path: Path, problem: str, remedy: str, placing: places.Placing | Place) -> Suspect:
    """Return the finding on something that can never be put where it is asked for."""
    tried = "would be tried again on every tick" if placing.on_failure == "retry" else "would stay where it is"
    return Suspect(
        "layout_without_room",
        path,
        f"there is no room: {problem}",
        f"{remedy}; on the field it {tried}",
    )
