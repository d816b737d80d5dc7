"""Numbers and values as parts of sentences."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rcj_challenges.scenario.models import state
from rcj_challenges.views.sheet.nouns import Nouns, plain, quoted


def number(value: float) -> str:
    """Return a number without superfluous zeros."""
    return f"{value:g}"


def seconds(value: float) -> str:
    """Return a duration: ``15 s``, ``10 min``."""
    return f"{value / 60:g} min" if value >= 120 and value % 60 == 0 else f"{value:g} s"


def metres(value: float) -> str:
    """Return a length in m, or in cm below 10 cm."""
    return f"{value * 100:g} cm" if value < 0.1 else f"{value:g} m"


def degrees(value_rad: float) -> str:
    """Return an angle in rad as degrees: ``34°``."""
    return f"{value_rad * 57.29578:.3g}°"


def heading(yaw_rad: float) -> str:
    """Return a direction on the floor: ``90° counter-clockwise from +x``."""
    return f"{degrees(abs(yaw_rad))} {'clockwise' if yaw_rad < 0 else 'counter-clockwise'} from +x"


def point(at: tuple[float, float]) -> str:
    """Return a point of the floor: ``(0.45, 0)``."""
    return f"({at[0]:g}, {at[1]:g})"


def times(count: int) -> str:
    """Return how often: ``once``, ``3 times``."""
    return "once" if count == 1 else f"{count} times"


def value(nouns: Nouns, value: Any) -> str:
    """Return a value of the scenario in words."""
    describe = _VALUES.get(type(value))
    return str(value).lower() if isinstance(value, bool) else describe(nouns, value) if describe else str(value)


def amount(nouns: Nouns, value: Any) -> str:
    """Return points or counts: a number, a counter, or a sum of weighted parts."""
    if isinstance(value, (int, float)):
        return number(value)
    if isinstance(value, tuple):
        return ", plus ".join(_part(nouns, part) for part in value)
    return _counted(nouns, value) or nouns.kept("counter", value.counter, value.entity)


def compared(nouns: Nouns, model: Any, unit: str = "") -> str:
    """Return the comparison of a condition: ``at least 3 and at most 5``."""
    parts = [
        f"{words} {amount(nouns, limit)}{unit}"
        for words, limit in (("at least", model.at_least), ("at most", model.at_most), ("exactly", model.equals))
        if limit is not None
    ]
    return " and ".join(parts)


def _counted(nouns: Nouns, model: Any) -> str:
    """Return for how much a flag, a draw or a word counts; an empty text for anything else."""
    if isinstance(model, state.FlagValue):
        return f"1 if {nouns.kept('flag', model.flag, model.entity)} is set"
    if isinstance(model, state.NumberWord):
        return _word(nouns, model) + (" (rounded down)" if model.word.endswith("_s") else "")
    return _VALUES[state.DrawValue](nouns, model) if isinstance(model, state.DrawValue) else ""


def _part(nouns: Nouns, part: Any) -> str:
    if isinstance(part, state.WeightedFlag):
        return f"{number(part.weight)} if {nouns.kept('flag', part.flag, part.entity)} is set"
    counter = _counted(nouns, part) or nouns.kept("counter", part.counter, part.entity)
    return counter if part.weight == 1 else f"{number(part.weight)} times {counter}"


def _word(_nouns: Nouns, model: state.WordValue) -> str:
    words = _WORDS[model.word]
    return f"{words} of {plain(model.of)}" if model.of else words


_WORDS = {
    "robot_name": "the name of the robot",
    "entity_name": "the name of the one concerned",
    "team_name": "the team name",
    "entrant": "the entrant",
    "score": "the score",
    "halftime": "the number of the half",
    "match_id": "the number of the match",
    "total_match_time_s": "the length of the half in s",
    "time_s": "the time in s",
    "time_left_s": "the time left in s",
    "measured": "what was measured",
    "limit": "the limit",
    "phase": "the phase",
    "seed_id": "a mark of the seed",
}

_VALUES: dict[type, Callable[[Nouns, Any], str]] = {
    state.CounterValue: lambda nouns, model: nouns.kept("counter", model.counter, model.entity),
    state.FlagValue: lambda nouns, model: f"whether {nouns.kept('flag', model.flag, model.entity)} is set",
    state.DrawValue: lambda _, model: f"what was drawn as {quoted(model.draw)}",
    state.WordValue: _word,
    state.PositionValue: lambda nouns, model: f"the position of {nouns.thing(model.position_of)}",
}
