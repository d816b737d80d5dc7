"""Checks of the field: entities off it, entities never on it, placements without room, conflicting placements."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations

from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.geometry.polygons import Point
from rcj_challenges.rules.base import Trigger
from rcj_challenges.rules.effects import HalfStart, Places, Removes, SetsPhase
from rcj_challenges.rules.placement import places
from rcj_challenges.scenario.checks.ground import bodies_at_start
from rcj_challenges.scenario.kits import chassis_of
from rcj_challenges.scenario.lint.base import LintContext, LintRule
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.outlines import Floor, Part, disc, outline_of, overlap
from rcj_challenges.scenario.rule_effects import fixed_spots
from rcj_challenges.scenario.shapes import clipped, start_pose, zone_outline
from rcj_challenges.scenario.tree import Path
from rcj_challenges.scenario.walk import effects_in


class OffTheField(LintRule, code="off-the-field"):
    """A zone, gate or spot without a point on the field: nothing enters it, crosses it, or can be placed there."""

    message = "{noun} '{name}' has no point on the field"
    help = "correct its numbers (in m, from the centre of the field), or remove it"
    at_key = True

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        (w, h), floor = ctx.scenario.field.bounds.reach_m, Floor(ctx.scenario.field)
        box = -w, -h, w, h
        for name, zone in ctx.scenario.zones.items():
            if not zone.inverted and not zone_outline(zone, box):
                yield self.at(("zones", name), noun="zone", name=name)
        for name, gate in ctx.scenario.gates.items():
            if gate.anchor is None and not clipped([gate.from_m, gate.to_m], box):
                yield self.at(("gates", name), noun="gate", name=name)
        for name, spot in fixed_spots(ctx.scenario).items():
            if not floor.has((spot.x_m, spot.y_m)):
                yield self.at(("spots", name), noun="spot", name=name)


class RobotWithoutProgram(LintRule, code="robot-without-program"):
    """A robot that no entrant drives and that is not idle: probably a mistake."""

    message = "no entrant drives '{name}', and it is not idle"
    help = "name it under entrants:, write idle: true for an obstacle, or remove it by '{name}: null'"
    at_key = True

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        driven = {robot for entrant in ctx.scenario.entrants.values() for robot in entrant.robots}
        for name, robot in ctx.scenario.robots.items():
            if name not in driven and not robot.idle:
                yield self.at(("robots", name), name=name)


class NeverOnTheField(LintRule, code="never-on-the-field"):
    """An entity that is removed as a half starts, and that no rule ever places."""

    message = "'{name}' is removed at the start and no rule ever places it"
    help = "place it in a rule, give for_s, or remove the entity by '{name}: null'"

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        placed = {name for one, rule, _ in ctx.reachable_effects(Places) for name in ctx.members(one.names, rule)}
        for layout in ctx.scenario.placements.values():
            placed.update(name for placing in layout for name in ctx.roster.expand(placing.entity))
        for effect, rule, path in ctx.reachable_effects(Removes):
            if effect.back_at is None and not rule.conditions and rule.moments(HalfStart):
                for gone in sorted(ctx.members(effect.names, rule) - placed):
                    yield self.at(path, name=gone)


class TwoRulesMoveOneThing(LintRule, code="two-rules-move-one-thing"):
    """Two rules with the same trigger place or remove the same thing: the one that fires last wins."""

    message = "it moves {entities} on the same trigger ({trigger}) as rule '{other}'; the later placement wins"
    help = "give both the same exclusive:, or conditions of which only one can hold"
    at_key = True

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
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
        leaves = any(not second.is_active_in(one.phase) for one in first.effects(SetsPhase))
        if leaves and first.priority < second.priority:
            return True
        return not any(first.is_active_in(phase) and second.is_active_in(phase) for phase in ctx.reachable_phases)


class NoRoom(LintRule, code="no-room"):
    """A placement for which there is no room: in a wall, or on something that the same layout places earlier."""

    message = "there is no room: '{name}' would stand {where}"
    help = "correct the place"

    def check(self, ctx: LintContext) -> Iterator[Diagnostic]:
        groups: list[list[tuple[Places, Path]]] = [
            [one] for name, rule in ctx.scenario.rules.items() for one in effects_in(name, rule, Places)
        ]
        groups += [
            [(places(one), ("placements", layout, index)) for index, one in enumerate(placings)]
            for layout, placings in ctx.scenario.placements.items()
        ]
        floor = Floor(ctx.scenario.field)
        fixed = [body.parts for body in bodies_at_start(ctx.scenario) if body.fixed]
        spots = fixed_spots(ctx.scenario)
        for group in groups:
            standing: dict[str, tuple[Part, ...]] = {}
            for placing, path in group:
                where = placing.at.fixed()
                spot = spots.get(where) if isinstance(where, str) else None
                point = where if isinstance(where, tuple) else (spot.x_m, spot.y_m) if spot is not None else None
                name = str(placing.names)
                outline = _outline(name, point, placing, ctx) if point is not None else None
                if outline is None or placing.how.noise_m != (0.0, 0.0) or placing.mirrors:
                    continue
                standing.pop(name, None)
                below = next((other for other, there in standing.items() if overlap(outline, there)), None)
                if not floor.holds(outline) or any(overlap(outline, one) for one in fixed):
                    yield self.at(path, name=name, where="in a wall or an obstacle, or off the field")
                elif below is not None:
                    yield self.at(path, name=name, where=f"on '{below}', which is placed before it")
                standing[name] = outline


def _outline(name: str, point: Point, placing: Places, ctx: LintContext) -> tuple[Part, ...] | None:
    """Return the parts of a ball or a robot at a point; None for anything else."""
    scenario = ctx.scenario
    if name not in {*scenario.robots, *scenario.balls}:
        return None
    facing = placing.how.facing
    yaw_rad = start_pose(scenario, name)[2] if facing == "start" or name in scenario.balls else facing
    if not isinstance(yaw_rad, int | float):
        return disc(chassis_of(scenario, name).size_m / 2).at((*point, 0.0))
    return outline_of(scenario, name).at((*point, yaw_rad))
