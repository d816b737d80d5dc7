"""How far a point is from something now: an entity, a spot, a point, the nearest point of a zone or of a gate."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from math import sqrt

from rcj_challenges.referee.compiling import Workshop
from rcj_challenges.referee.places import spot_name
from rcj_challenges.referee.sequences import GateLine

_Point = tuple[float, float]


@dataclass(frozen=True)
class Target:
    """Something that a distance is measured to.

    Attributes:
        away_m: returns how far the point (x, y) is from it now, in m; None while it is off the field.
        place: returns where it is now, None while it is off the field; itself None of a zone or a gate, which is no
            point, and from which nothing is measured.
        entity: the index of the entity that it is, or with which it moves; None of what belongs to none.
    """

    away_m: Callable[[float, float], float | None]
    place: Callable[[], _Point | None] | None
    entity: int | None = None

    def is_with(self, entity: int | None) -> bool:
        """Return whether it is this entity, or moves with it: nothing is measured from itself."""
        return entity is not None and self.entity == entity


def targets_of(named: str | _Point, workshop: Workshop, each: str | None) -> tuple[Target, ...]:
    """Return what a name stands for, groups expanded, or a point.

    Raises:
        ValueError: it is nothing on the field.
    """
    if isinstance(named, tuple):
        return (_standing(lambda: named),)
    return tuple(_target(name, workshop) for name in workshop.members(named, each))


def _target(name: str, workshop: Workshop) -> Target:
    scenario, state = workshop.scenario, workshop.state
    if name in workshop.roster.entities:
        return _entity(workshop.roster.index[name], workshop)
    if name in scenario.zones:
        return Target(workshop.zone(name).away_m, None)
    if name in scenario.gates:
        gate = GateLine(scenario.gates[name], workshop)
        return Target(gate.distance_m, None, gate.anchor)
    spot = spot_name(workshop, name)
    return _standing(lambda: state.spots[spot])


def _entity(index: int, workshop: Workshop) -> Target:
    state = workshop.state

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
