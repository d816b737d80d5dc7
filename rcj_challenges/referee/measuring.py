"""Values that are measured when a rule fires: how far things are apart or have come, how long a timer has run."""

from __future__ import annotations

from collections.abc import Callable

from rcj_challenges.facts.timing import s_from_ticks
from rcj_challenges.referee.compiling import CompileContext
from rcj_challenges.referee.nearness import targets_of
from rcj_challenges.rules.comparison import MM_DIGITS
from rcj_challenges.rules.values import DistanceValue, TimerValue, WayValue


def distance_reader(value: DistanceValue, context: CompileContext, each: str | None) -> Callable[[], float | None]:
    """Return what measures in m, to the millimetre, how far two things are apart now; None if one is off the field."""
    here, there = (targets_of(end, context, each) for end in value.distance)
    if any(one.place is None for one in here):
        here, there = there, here  # from what is a point to a zone or a gate
    pairs = [
        (one.place, other.away_m)
        for one in here
        for other in there
        if one.place is not None and not other.is_with(one.entity)
    ]

    def read() -> float | None:
        starts = ((place(), away_m) for place, away_m in pairs)
        found = (away_m(*start) for start, away_m in starts if start is not None)
        nearest = min((one for one in found if one is not None), default=None)
        return None if nearest is None else round(nearest, MM_DIGITS)

    return read


def way_reader(value: WayValue, context: CompileContext, each: str | None) -> Callable[[], float]:
    """Return what tells in m, to the millimetre, how far an entity has driven or rolled in the half."""
    ways, entity = context.state.ways, context.entity(value.way, each)
    context.state.follow_way(entity)
    return lambda: round(ways[entity], MM_DIGITS)


def timer_reader(value: TimerValue, context: CompileContext, each: str | None) -> Callable[[], float]:
    """Return what tells in s how long a timer has run; of several the longest."""
    state, clocks = context.state, context.state.timers[value.timer]
    whose = context.whose(value.entity, each)
    meant = tuple(clocks.values()) if whose is None else (clocks[whose],)
    return lambda: s_from_ticks(max(clock.ticks(state.tick) for clock in meant))
