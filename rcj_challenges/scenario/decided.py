"""What a test decides of where chance sets spots: only what chance could."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import product

from rcj_challenges.geometry.polygons import Point, distance_to_segment_m
from rcj_challenges.rules.actions.set_spot import SetSpot
from rcj_challenges.rules.mirror import Mirror
from rcj_challenges.rules.places.on_line import OnLine
from rcj_challenges.rules.places.uniform_in import UniformIn
from rcj_challenges.scenario.floor import floor_parts, on_floor
from rcj_challenges.scenario.floor_shapes import lies_in
from rcj_challenges.scenario.models.scenario import Expectation, Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.tree import Path
from rcj_challenges.scenario.visiting import Found

_ON_LINE_M = 0.001
"""A point is on a line that is no farther away: authors round to the millimetre."""

Places = Point | tuple[Point, ...]
"""What a test decides of a spot: where chance sets it first, or the first times in order."""


def places_of(decided: Places) -> tuple[Point, ...]:
    """Return the places that a test decides for a spot, in order."""
    return decided if isinstance(decided[0], tuple) else (decided,)


def check_decided_spots(test: Expectation, path: Path, scenario: Scenario, roster: Roster) -> Iterator[Found]:
    """Yield the places that a test decides for a spot and to which chance never sets it."""
    for name, decided in (test.spots or {}).items():
        if name not in scenario.spots:
            continue
        by_chance = list(_by_chance(name, scenario))
        where = (*path, "spots", name)
        if not by_chance:
            message = f"chance never sets '{name}'; where it is at the end is compared under poses"
            yield Found(where, message, at_key=True)
            continue
        for index, point in enumerate(places_of(decided)):
            if not any(_may_be_set(point, action, scenario, roster) for action in by_chance):
                at = where if decided is point else (*where, index)
                yield Found(at, f"chance never sets '{name}' to ({point[0]:g}, {point[1]:g})")


def _by_chance(name: str, scenario: Scenario) -> Iterable[SetSpot]:
    return (
        action
        for rule in scenario.rules.values()
        for action in rule.actions
        if isinstance(action, SetSpot) and action.spot == name and isinstance(action.to, UniformIn | OnLine)
    )


def _may_be_set(point: Point, action: SetSpot, scenario: Scenario, roster: Roster) -> bool:
    if not on_floor(point, floor_parts(scenario.field)):
        return False
    points = [(point[0] * sign_x, point[1] * sign_y) for sign_x, sign_y in _signs(action.mirror)]
    match action.to:
        case OnLine(on_line=(start, end)):
            return any(distance_to_segment_m(*one, *start, *end) <= _ON_LINE_M for one in points)
        case UniformIn(uniform_in=names):
            zones = [scenario.zones.get(name) for name in roster.expand(names)]
            # Of what is no zone it is said where it is written; nothing is wrong here then.
            return any(zone is None or lies_in(one, zone) for one, zone in product(points, zones))
    return False


def _signs(mirror: Mirror | None) -> list[tuple[int, int]]:
    """Return by what x and y may be turned over: with a flag, or not."""
    if mirror is None:
        return [(1, 1)]
    turned = (-1 if mirror.axis in ("x", "both") else 1, -1 if mirror.axis in ("y", "both") else 1)
    return [turned] if mirror.when is None else [turned, (1, 1)]
