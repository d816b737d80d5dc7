"""Distances that cannot be measured, and zones without a centre: what wide things are, seen from a point."""

from __future__ import annotations

from collections.abc import Iterator
from math import atan2

from rcj_challenges.rules.actions.set_spot import SetSpot
from rcj_challenges.rules.fields import Strict
from rcj_challenges.rules.values.distance import DistanceValue
from rcj_challenges.scenario.models.field import Box, Cylinder, Obstacle, Wall
from rcj_challenges.scenario.models.places import CircleZone, PolygonZone, RectZone, Zone
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.roster import Roster, written_for
from rcj_challenges.scenario.tree import Path
from rcj_challenges.scenario.visiting import Found, visit

Point = tuple[float, float]


def check_measured(scenario: Scenario) -> Iterator[Found]:
    """Yield distances between two zones, gates or walls, and spots that are set to a zone without a centre."""
    roster = Roster.of(scenario)
    for name, rule in scenario.rules.items():
        yield from _within(rule, ("rules", name), rule, scenario, roster)
    yield from _within(scenario.broadcast, ("broadcast",), None, scenario, roster)


def centre_of(zone: Zone) -> Point | None:
    """Return the centre of a zone; None of one that has none, or several points with equal right to the name."""
    if zone.inverted:
        return None
    if isinstance(zone, CircleZone):
        return zone.centre_m
    sides = (zone.x_min_m, zone.x_max_m, zone.y_min_m, zone.y_max_m) if isinstance(zone, RectZone) else (None,) * 4
    x_min, x_max, y_min, y_max = sides
    if x_min is None or x_max is None or y_min is None or y_max is None:
        return None
    return (x_min + x_max) / 2, (y_min + y_max) / 2


def middle_of(obstacle: Obstacle) -> tuple[float, float, float]:
    """Return where a fixed obstacle stands, [x, y, yaw] in m and rad: a wall from its middle along its line."""
    match obstacle:
        case Wall():
            (ax, ay), (bx, by) = obstacle.from_m, obstacle.to_m
            return (ax + bx) / 2, (ay + by) / 2, atan2(by - ay, bx - ax)
        case Box():
            return *obstacle.centre_m, obstacle.yaw_rad
        case Cylinder():
            return *obstacle.centre_m, 0.0


def _within(part: object, path: Path, rule: Rule | None, scenario: Scenario, roster: Roster) -> Iterator[Found]:
    for model, at in visit(part, path):
        yield from _apart(model, at, rule, scenario, roster)
        if isinstance(model, SetSpot) and isinstance(model.to, str):
            for name in _meant(model.to, rule, roster):
                if name in scenario.zones and centre_of(scenario.zones[name]) is None:
                    message = f"zone '{name}' {_why(scenario.zones[name])}; set the spot to an entity, a spot or [x, y]"
                    yield Found((*at, "to"), message)


def _apart(model: Strict, path: Path, rule: Rule | None, scenario: Scenario, roster: Roster) -> Iterator[Found]:
    if not isinstance(model, DistanceValue):
        return
    walls = (name for name, obstacle in scenario.obstacles.items() if isinstance(obstacle, Wall))
    wide = {
        **dict.fromkeys(scenario.zones, "zone"),
        **dict.fromkeys(scenario.gates, "gate"),
        **dict.fromkeys(walls, "wall"),
    }
    ends = [_meant(end, rule, roster) if isinstance(end, str) else () for end in model.distance]
    firsts = [next((name for name in end if name in wide), None) for end in ends]
    one, other = firsts
    if one is not None and other is not None:
        alike = wide[one] == wide[other]
        told = f"'{one}' is a {wide[one]} and '{other}' {'another' if alike and one != other else f'a {wide[other]}'}"
        yield Found((*path, "distance"), f"{told}; one end of a distance is an entity, a spot or [x, y]")


def _meant(name: str, rule: Rule | None, roster: Roster) -> tuple[str, ...]:
    return roster.may_be(written_for(name, rule.for_each if rule is not None else None))


def _why(zone: Zone) -> str:
    if zone.inverted:
        return "is everything but its shape, which has no centre"
    if isinstance(zone, PolygonZone):
        return "is a polygon, which has no one centre"
    return "has no end in some direction, and so no centre"
