"""Numbers and values as parts of sentences."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from rcj_challenges.rules.phrasing import listed, number, plain, quoted, quoted_measure, seconds
from rcj_challenges.rules.values import (
    CounterValue,
    DistanceValue,
    DrawnDuration,
    DrawValue,
    FlagValue,
    HeldValue,
    HighestOfOthers,
    LastTouchValue,
    LowestOfOthers,
    NumberDraw,
    NumberTimer,
    NumberTold,
    NumberWord,
    PositionValue,
    TimerValue,
    ToldValue,
    WayValue,
    WeightedDraw,
    WeightedFlag,
    WeightedTold,
    WordValue,
)

if TYPE_CHECKING:
    from rcj_challenges.views.sheet.nouns import Nouns


def lasting(nouns: Nouns, lasts_s: float | DrawnDuration | CounterValue) -> str:
    """Return how long something lasts: ``15 s``, ``5 s or 8 s, as “pause” is drawn``, as many s as a counter says."""
    if isinstance(lasts_s, CounterValue):
        return f"as many s as {amount(nouns, lasts_s)} says"
    if not isinstance(lasts_s, DrawnDuration):
        return seconds(lasts_s)
    times_s = sorted({float(value) for value in nouns.scenario.draws[lasts_s.draw].values})
    return f"{listed([seconds(time_s) for time_s in times_s], 'or')}, as {quoted_measure(lasts_s.draw)} is drawn"


def value(nouns: Nouns, value: Any) -> str:
    """Return a value of the scenario in words."""
    describe = _VALUES.get(type(value))
    return str(value).lower() if isinstance(value, bool) else describe(nouns, value) if describe else str(value)


def amount(nouns: Nouns, value: Any) -> str:
    """Return points, counts or limits: a number, a counter, a sum of weighted parts, or the most or least of others."""
    if isinstance(value, (int, float)):
        return number(value)
    if isinstance(value, tuple):
        return _sum(nouns, value)
    if isinstance(value, LowestOfOthers):
        return f"the lowest counter {quoted_measure(value.lowest)} of {nouns.all_but_each(value.lowest)}"
    if isinstance(value, HighestOfOthers):
        return f"the highest counter {quoted_measure(value.highest)} of {nouns.all_but_each(value.highest)}"
    return _counted(nouns, value) or nouns.kept("counter", value.counter, value.entity)


def _counted(nouns: Nouns, model: Any) -> str:
    """Return for how much a flag or what is told counts; an empty text for anything else."""
    if isinstance(model, FlagValue):
        return f"1 if {nouns.kept('flag', model.flag, model.entity)} is set"
    if isinstance(model, NumberWord):
        return _seconds(_word(nouns, model), model) if model.word.endswith("_s") else _word(nouns, model)
    if isinstance(model, NumberTimer):
        return _seconds(_ran(nouns, model), model)
    if isinstance(model, DistanceValue):
        return _apart(nouns, model)
    if isinstance(model, WayValue):
        return _come(nouns, model)
    return _VALUES[type(model)](nouns, model) if isinstance(model, DrawValue | NumberTold) else ""


def _seconds(time: str, model: Any) -> str:
    """Return a time with what of it counts: full seconds, before any weight, or its fraction too."""
    return f"{time} (with its fraction)" if model.fraction else time.replace(" in s", " in full seconds", 1)


def _sum(nouns: Nouns, parts: Sequence[Any]) -> str:
    """Return the sum of weighted parts: ``5, minus 0.1 times the time in full seconds``."""
    said = ""
    for part in parts:
        weight = part if isinstance(part, (int, float)) else part.weight
        if not said:
            said = _part(nouns, part, weight)
        else:
            said += f", {'minus' if weight < 0 else 'plus'} {_part(nouns, part, abs(weight))}"
    return said


def _part(nouns: Nouns, part: Any, weight: float) -> str:
    if isinstance(part, (int, float)):
        return number(weight)
    if isinstance(part, WeightedFlag):
        return f"{number(weight)} if {nouns.kept('flag', part.flag, part.entity)} is set"
    counter = _counted(nouns, part) or nouns.kept("counter", part.counter, part.entity)
    return counter if weight == 1 else f"{number(weight)} times {counter}"


def _apart(nouns: Nouns, model: DistanceValue) -> str:
    here, there = model.distance
    one, other = nouns.point(here, there), nouns.point(there, here)
    inside = any(name in nouns.scenario.zones for end in model.distance for name in nouns.meant(end))
    return f"the distance between {one} and {other} in m" + (" (0 inside)" if inside else "")


def _come(nouns: Nouns, model: WayValue) -> str:
    return f"{nouns.owned('way', model.way)} in this half in m"


def _ran(nouns: Nouns, model: TimerValue) -> str:
    owners = None if model.entity else nouns.owners("timer", model.timer)
    timer = nouns.kept("timer", model.timer, model.entity)
    if owners is not None:
        timer = f"the longest running timer {quoted(model.timer)} of {nouns.all_of(owners).text}"
    return f"the time in s that {timer} has run"


def _word(nouns: Nouns, model: WordValue) -> str:
    words = nouns.measured if model.word == "measured" else _WORDS[model.word]
    return f"{words} of {plain(model.of)}" if model.of else words


_WORDS = {
    "robot_name": "the name of the robot",
    "entity_name": "the name of the one concerned",
    "each_name": "the name of the one that the rule is for",
    "other_name": "the name of the other one",
    "team_name": "the team name",
    "entrant": "the entrant",
    "score": "the score",
    "halftime": "the number of the half",
    "match_id": "the number of the match",
    "total_match_time_s": "the length of the half in s",
    "time_s": "the time in s",
    "time_left_s": "the time left in s",
    "limit": "the limit",
    "phase": "the phase",
    "seed_id": "a mark of the seed",
}


def _number_heard(nouns: Nouns, model: NumberTold) -> str:
    return f"the number that {nouns.thing(model.told)} has told the referee last"


def _drawn(nouns: Nouns, model: DrawValue) -> str:
    return nouns.what_drawn(model.draw)


_VALUES: dict[type, Callable[[Nouns, Any], str]] = {
    CounterValue: lambda nouns, model: nouns.kept("counter", model.counter, model.entity),
    FlagValue: lambda nouns, model: f"whether {nouns.kept('flag', model.flag, model.entity)} is set",
    DrawValue: _drawn,
    NumberDraw: _drawn,
    WeightedDraw: _drawn,
    WordValue: _word,
    PositionValue: lambda nouns, model: f"the position of {nouns.thing(model.position_of)}",
    DistanceValue: _apart,
    WayValue: _come,
    TimerValue: _ran,
    HeldValue: lambda nouns, model: f"whether {nouns.thing(model.held)} is held",
    LastTouchValue: lambda nouns, model: f"the name of the last to touch {nouns.thing(model.last_touch)}",
    ToldValue: lambda nouns, model: f"what {nouns.thing(model.told)} has told the referee last",
    NumberTold: _number_heard,
    WeightedTold: _number_heard,
}
