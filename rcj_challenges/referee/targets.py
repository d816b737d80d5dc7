"""How far a point is from something now: a thing, a spot, a point, the nearest point of a zone, gate or wall."""

from __future__ import annotations

from collections.abc import Callable
from math import sqrt
from typing import TYPE_CHECKING

from rcj_challenges.geometry.polygons import distance_to_segment_m
from rcj_challenges.scenario.models.field import Obstacle, Wall
from rcj_challenges.tracking.target import Target

if TYPE_CHECKING:
    from rcj_challenges.referee.scope import NameScope

_Point = tuple[float, float]


def targets_of(named: str | _Point, scope: NameScope) -> tuple[Target, ...]:
    """Return the target of a name, groups expanded, or of a point.

    Raises:
        ValueError: it is nothing on the field.
    """
    if isinstance(named, tuple):
        return (_standing(lambda: named),)
    found: list[Target] = []
    for name in scope.members(named):
        among = scope.roster.drawn.get(name)
        found += [_target(name, scope)] if among is None else [_if_drawn(name, one, scope) for one in among]
    return tuple(found)


def _if_drawn(draw: str, name: str, scope: NameScope) -> Target:
    """Return one of those among which a draw decides: it is nowhere while another one is drawn."""
    draws, target = scope.state.draws, _target(name, scope)
    place = target.place
    return Target(
        lambda x_m, y_m: target.away_m(x_m, y_m) if draws[draw] == name else None,
        None if place is None else (lambda: place() if draws[draw] == name else None),
        target.entity,
    )


def _target(name: str, scope: NameScope) -> Target:
    scenario, state = scope.scenario, scope.state
    if name in scope.roster.entities:
        return _entity(scope.roster.index[name], scope)
    if name in scenario.zones:
        return Target(scope.zone(name).away_m, None)
    if name in scenario.gates:
        gate = scope.gate(name)
        return Target(gate.distance_m, None, gate.anchor)
    if name in scenario.obstacles:
        return _fixed(scenario.obstacles[name])
    spot = scope.spot_name(name)
    return _standing(lambda: state.spots[spot])


def _fixed(obstacle: Obstacle) -> Target:
    """Return an obstacle that stands fast: its centre, as of one that can move; of a wall the line in its middle."""
    if isinstance(obstacle, Wall):
        ends = (*obstacle.from_m, *obstacle.to_m)
        return Target(lambda x_m, y_m: distance_to_segment_m(x_m, y_m, *ends), None)
    centre = obstacle.centre_m
    return _standing(lambda: centre)


def _entity(index: int, scope: NameScope) -> Target:
    state = scope.state

    def place() -> _Point | None:
        return state.poses[index][:2] if state.present[index] else None

    def away_m(x_m: float, y_m: float) -> float | None:
        if not state.present[index]:
            return None
        px, py, _ = state.poses[index]
        return sqrt((x_m - px) ** 2 + (y_m - py) ** 2)

    return Target(away_m, place, index)


def _standing(place: Callable[[], _Point]) -> Target:
    def away_m(x_m: float, y_m: float) -> float:
        px, py = place()
        return sqrt((x_m - px) ** 2 + (y_m - py) ** 2)

    return Target(away_m, place)
