"""Values that are measured when a rule fires: how far things are apart or have come, how long a timer has run."""

from __future__ import annotations

from collections.abc import Callable
from math import sqrt

from rcj_challenges.facts.timing import s_from_ticks
from rcj_challenges.referee.compiling import Workshop
from rcj_challenges.referee.places import spot_name
from rcj_challenges.scenario.models.state import DistanceValue, TimerValue, WayValue

_Point = tuple[float, float]
_End = int | str | _Point
"""What is measured from or to: the index of an entity, the name of a spot, or a point."""

_MM_DIGITS = 3


def distance_reader(value: DistanceValue, workshop: Workshop, each: str | None) -> Callable[[], float | None]:
    """Return what measures in m, to the millimetre, how far two things are apart now; None if one is off the field."""
    here, there = (_ends(end, workshop, each) for end in value.distance)
    # Nothing is measured from itself.
    pairs = [(one, other) for one in here for other in there if one != other or not isinstance(one, int)]
    state = workshop.state

    def at(end: _End) -> _Point:
        if isinstance(end, int):
            return state.poses[end][:2]
        return state.spots[end] if isinstance(end, str) else end

    def read() -> float | None:
        ends = (
            (at(one), at(other))
            for one, other in pairs
            if all(state.present[end] for end in (one, other) if isinstance(end, int))
        )
        nearest = min((sqrt((x - px) ** 2 + (y - py) ** 2) for (x, y), (px, py) in ends), default=None)
        return None if nearest is None else round(nearest, _MM_DIGITS)

    return read


def _ends(named: str | _Point, workshop: Workshop, each: str | None) -> tuple[_End, ...]:
    """Return between what is measured."""
    if isinstance(named, tuple):
        return (named,)
    index, entities = workshop.roster.index, workshop.roster.entities
    members = workshop.members(named, each)
    return tuple(index[name] if name in entities else spot_name(workshop, name) for name in members)


def way_reader(value: WayValue, workshop: Workshop, each: str | None) -> Callable[[], float]:
    """Return what tells in m, to the millimetre, how far an entity has driven or rolled in the half."""
    ways, entity = workshop.state.ways, workshop.entity(value.way, each)
    workshop.state.follow_way(entity)
    return lambda: round(ways[entity], _MM_DIGITS)


def timer_reader(value: TimerValue, workshop: Workshop, each: str | None) -> Callable[[], float]:
    """Return what tells in s how long a timer has run; of several the longest."""
    state, clocks = workshop.state, workshop.state.timers[value.timer]
    whose = workshop.whose(value.entity, each)
    meant = tuple(clocks.values()) if whose is None else (clocks[whose],)
    return lambda: s_from_ticks(max(clock.ticks(state.tick) for clock in meant))
