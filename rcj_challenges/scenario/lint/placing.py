"""Checks of the field: what lies off it, who never is on it, what finds no room, what two rules move at once."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import combinations

from rcj_challenges.geometry.polygons import Point
from rcj_challenges.rules.actions.place import Place
from rcj_challenges.rules.actions.remove import Remove
from rcj_challenges.rules.actions.set_phase import SetPhase
from rcj_challenges.rules.base import Trigger
from rcj_challenges.rules.conditions.distance import Distance
from rcj_challenges.rules.places.furthest_free import FurthestFree
from rcj_challenges.rules.places.nearest_free import NearestFree
from rcj_challenges.rules.places.on_line import OnLine
from rcj_challenges.rules.places.point import AtPoint
from rcj_challenges.rules.places.spot import AtSpot
from rcj_challenges.rules.places.uniform_in import UniformIn
from rcj_challenges.rules.triggers.half_started import HalfStarted
from rcj_challenges.rules.values.distance import DistanceValue
from rcj_challenges.scenario.checks.ground import Floor, obstacle_bodies
from rcj_challenges.scenario.floor import floor_parts, on_floor
from rcj_challenges.scenario.floor_shapes import points_in, segment_has_floor, zone_has_floor
from rcj_challenges.scenario.lint.base import LintRule, Suspicion
from rcj_challenges.scenario.lint.context import LintContext, is_active_in
from rcj_challenges.scenario.models import places
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.outlines import Part, disc, overlap, robot_outline
from rcj_challenges.scenario.set_spots import fixed_spots
from rcj_challenges.scenario.tree import Path

_Placing = places.Placing | Place


class OffTheField(LintRule):
    """A zone, gate or spot without a point on the field: nothing enters it, crosses it, or can be placed there."""

    code = "off-the-field"
    message = "{noun} '{name}' has no point on the field"
    help = "correct its numbers (in m, from the centre of the field), or remove it"
    at_key = True

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield places that lie outside the walls. What rules only measure distances to may lie there."""
        scenario = ctx.scenario
        parts = floor_parts(scenario.field)
        met = {
            member
            for use in ctx.uses
            if use.is_on_field and not issubclass(use.model, Distance | DistanceValue)
            for member in ctx.roster.expand(use.name)
        }
        measured = {member for use in ctx.uses for member in ctx.roster.expand(use.name)} - met
        for name, zone in scenario.zones.items():
            if name not in measured and not zone_has_floor(zone, parts):
                yield self.at(("zones", name), noun="zone", name=name)
        for name, gate in scenario.gates.items():
            moves = gate.anchor is not None
            if not moves and name not in measured and not segment_has_floor(gate.from_m, gate.to_m, parts):
                yield self.at(("gates", name), noun="gate", name=name)
        for name, spot in fixed_spots(scenario).items():
            if not on_floor((spot.x_m, spot.y_m), parts):
                yield self.at(("spots", name), noun="spot", name=name)


class RobotWithoutProgram(LintRule):
    """A robot that no entrant drives and that is not idle: probably a mistake."""

    code = "robot-without-program"
    message = "no entrant drives '{name}', and it is not idle"
    help = "name it under entrants:, write idle: true for an obstacle, or remove it by '{name}: null'"
    at_key = True

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield such robots."""
        driven = {robot for entrant in ctx.scenario.entrants.values() for robot in entrant.robots}
        for name, robot in ctx.scenario.robots.items():
            if name not in driven and not robot.idle:
                yield self.at(("robots", name), name=name)


class NeverOnTheField(LintRule):
    """An entity that is removed as a half starts, and that no rule ever places."""

    code = "never-on-the-field"
    message = "'{name}' is removed at the start and no rule ever places it"
    help = "place it in a rule, give for_s, or remove the entity by '{name}: null'"

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield the removal."""
        placed = self._placed(ctx)
        for name, rule in ctx.reachable_rules():
            if rule.conditions or not any(isinstance(trigger, HalfStarted) for trigger in rule.triggers):
                continue
            for index, action in enumerate(rule.actions):
                if isinstance(action, Remove) and action.for_s is None:
                    for gone in sorted(ctx.members(action.entity, rule) - placed):
                        yield self.at(("rules", name, "actions", index), name=gone)

    @staticmethod
    def _placed(ctx: LintContext) -> set[str]:
        placed: set[str] = set()
        for _, rule in ctx.reachable_rules():
            for action in rule.actions:
                if isinstance(action, Place) and action.entity is not None:
                    placed |= ctx.members(action.entity, rule)
        for layout in ctx.scenario.placements.values():
            for placing in layout:
                placed.update(ctx.roster.expand(placing.entity))
        return placed


class TwoRulesMoveOneThing(LintRule):
    """Two rules with the same trigger place or remove the same thing: the one that fires last wins."""

    code = "two-rules-move-one-thing"
    message = "it moves {entities} on the same trigger ({trigger}) as rule '{other}'; the later placement wins"
    help = "give both the same exclusive:, or conditions of which only one can hold"
    at_key = True

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield the later rule of each pair, unless conditions or a phase can keep them apart."""
        movers = [(name, rule, ctx.moved(rule)) for name, rule in ctx.reachable_rules()]
        for (first, one, moved), (second, other, also_moved) in combinations([one for one in movers if one[2]], 2):
            trigger = next((trigger for trigger in one.triggers if trigger in other.triggers), None)
            both = moved & also_moved
            if trigger is not None and both and not self._are_kept_apart(one, other, trigger, ctx):
                yield self.at(("rules", second), entities=", ".join(sorted(both)), trigger=trigger.name(), other=first)

    @staticmethod
    def _are_kept_apart(first: Rule, second: Rule, trigger: Trigger, ctx: LintContext) -> bool:
        if first.exclusive is not None and first.exclusive == second.exclusive:
            return True
        if first.conditions != second.conditions and first.conditions and second.conditions:
            return True
        if first.for_each != second.for_each and "each" in {*dict(trigger).values()}:
            return True
        if any(isinstance(action, SetPhase) and not is_active_in(second, action.phase) for action in first.actions):
            return True
        return not any(is_active_in(first, phase) and is_active_in(second, phase) for phase in ctx.reachable_phases)


class NoRoom(LintRule):
    """A placement for which there is no room: in a wall, or on something that the same layout places earlier."""

    code = "no-room"
    message = "there is no room: {why}"
    help = "correct the place, or make it larger"

    def check(self, ctx: LintContext) -> Iterator[Suspicion]:
        """Yield placements that fail wherever chance puts them."""
        room = _Room(ctx)
        for name, layout in ctx.scenario.placements.items():
            for path, why in room.failures([(placing, ("placements", name, i)) for i, placing in enumerate(layout)]):
                yield self.at(path, why=why)
        for model, at in ctx.models:
            if isinstance(model, Place) and model.at is not None and model.entity is not None:
                for path, why in room.failures([(model, at)]):
                    yield self.at(path, why=why)


class _Room:
    """Places things one after the other where the file puts them for certain."""

    _LINE_SAMPLES = 65

    def __init__(self, ctx: LintContext) -> None:
        self._ctx = ctx
        self._scenario = ctx.scenario
        self._floor = Floor(self._scenario.field)
        self._fixed = [body.parts for body in obstacle_bodies(self._scenario) if body.fixed]
        self._spots = {name: (spot.x_m, spot.y_m) for name, spot in fixed_spots(self._scenario).items()}

    def failures(self, placings: Sequence[tuple[_Placing, Path]]) -> Iterator[tuple[Path, str]]:
        """Yield the placements that fit nowhere, with the reason."""
        standing: dict[str, tuple[Part, ...]] = {}
        for placing, path in placings:
            points = self._points(placing)
            names = [name for name in self._names(placing) if name in self._ctx.roster.index]
            if points is None or not names:
                continue
            if 1 < len(points) < len(names) and not isinstance(placing.at, UniformIn | OnLine):
                yield path, f"{len(names)} things cannot share {len(points)} spots"
                continue
            for name in names:
                standing.pop(name, None)
                why = self._why_not(name, placing, points, standing)
                if why:
                    yield path, why
                    break
                if len(points) == 1:
                    standing[name] = self._outline(name, points[0], placing)

    def _names(self, placing: _Placing) -> tuple[str, ...]:
        names = placing.entity
        return () if names is None or names == "each" else self._ctx.roster.expand(names)

    def _points(self, placing: _Placing) -> list[Point] | None:
        """Return where a placement may put things; None if the file does not decide it."""
        if placing.noise_m != (0.0, 0.0) or placing.mirror is not None:
            return None
        at = placing.at
        if isinstance(at, AtPoint):
            return [at.point]
        if isinstance(at, UniformIn):
            zones = self._ctx.roster.expand(at.uniform_in)
            return [point for name in zones for point in points_in(self._scenario.zones[name])]
        if isinstance(at, OnLine):
            (ax, ay), (bx, by) = at.on_line
            shares = [index / (self._LINE_SAMPLES - 1) for index in range(self._LINE_SAMPLES)]
            return [(ax + share * (bx - ax), ay + share * (by - ay)) for share in shares]
        names: tuple[str, ...] = ()
        if isinstance(at, AtSpot):
            names = (at.spot,)
        elif isinstance(at, NearestFree):
            names = self._ctx.roster.expand(at.nearest_free)
        elif isinstance(at, FurthestFree):
            names = self._ctx.roster.expand(at.furthest_free)
        return [self._spots[name] for name in names] if names and self._spots.keys() >= {*names} else None

    def _why_not(self, name: str, placing: _Placing, points: list[Point], standing: dict[str, tuple[Part, ...]]) -> str:
        """Return why a thing fits on none of the points, or an empty text."""
        blocked_by = ""
        for point in points:
            outline = self._outline(name, point, placing)
            if not self._floor.holds(outline) or any(overlap(outline, fixed) for fixed in self._fixed):
                continue
            blocked_by = next((other for other, there in standing.items() if overlap(outline, there)), "")
            if not blocked_by:
                return ""
        if blocked_by:
            return f"'{name}' would stand on '{blocked_by}', which is placed before it"
        return f"'{name}' would stand in a wall or an obstacle, or off the field"

    def _outline(self, name: str, point: Point, placing: _Placing) -> tuple[Part, ...]:
        scenario = self._scenario
        if name in scenario.balls:
            return disc(scenario.balls[name].radius_m).at((*point, 0.0))
        robot = scenario.robots.get(name)
        if robot is None:  # of a movable obstacle its smallest extent is enough here
            return disc(0.005).at((*point, 0.0))
        chassis = scenario.kits[robot.kit].chassis
        yaw_rad = robot.start.yaw_rad if placing.facing == "start" else placing.facing
        if not isinstance(yaw_rad, int | float):
            return disc(chassis.size_m / 2).at((*point, 0.0))
        return robot_outline(chassis).at((*point, yaw_rad))
