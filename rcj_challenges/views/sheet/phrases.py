"""Names and values as parts of sentences."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from rcj_challenges.scenario.models import state


def named(names: str | tuple[str, ...]) -> str:
    """Return names as people list them: ``each robot``, ``ball``, ``Y1 or Y2``."""
    if isinstance(names, tuple):
        return " or ".join(named(name) for name in names)
    return {"each": "it"}.get(names, names.replace("_", " "))


def number(value: float) -> str:
    """Return a number without superfluous zeros."""
    return f"{value:g}"


def seconds(value: float) -> str:
    """Return a duration: ``15 s``, ``10 min``."""
    return f"{value / 60:g} min" if value >= 120 and value % 60 == 0 else f"{value:g} s"


def metres(value: float) -> str:
    """Return a length in m, or in cm below 10 cm."""
    return f"{value * 100:g} cm" if value < 0.1 else f"{value:g} m"


def place(value: Any) -> str:
    """Return a name, or a point as ``(x, y)``."""
    return named(value) if isinstance(value, str) else f"({value[0]:g}, {value[1]:g})"


def value(value: Any) -> str:
    """Return a value of the scenario in words."""
    describe = _VALUES.get(type(value))
    return str(value).lower() if isinstance(value, bool) else describe(value) if describe else str(value)


def amount(value: Any) -> str:
    """Return points or counts: a number, a counter, or a sum of weighted parts."""
    if isinstance(value, (int, float)):
        return number(value)
    if isinstance(value, tuple):
        return " plus ".join(_part(part) for part in value)
    return _counter(value)


def compared(model: Any, unit: str = "") -> str:
    """Return the comparison of a condition: ``at least 3 and at most 5``."""
    parts = [
        f"{words} {amount(limit)}{unit}"
        for words, limit in (("at least", model.at_least), ("at most", model.at_most), ("exactly", model.equals))
        if limit is not None
    ]
    return " and ".join(parts)


def quantified(of: Any, names: str | tuple[str, ...]) -> str:
    """Return who must satisfy a condition: ``any of the robots``."""
    if names == "each" or (isinstance(names, str) and of == "any"):
        return named(names)
    words = {"any": "any of", "all": "all of", "none": "none of"}.get(of) if isinstance(of, str) else None
    return f"{words or f'at least {of.at_least} of'} {named(names)}"


def _counter(model: state.CounterValue) -> str:
    return named(model.counter) + (f" of {named(model.entity)}" if model.entity else "")


def _part(part: state.WeightedCounter | state.WeightedFlag) -> str:
    if isinstance(part, state.WeightedCounter):
        return named(part.counter) if part.weight == 1 else f"{number(part.weight)} times {named(part.counter)}"
    return f"{number(part.weight)} if {named(part.flag)}"


_VALUES: dict[type, Callable[[Any], str]] = {
    state.CounterValue: _counter,
    state.FlagValue: lambda model: f"whether {named(model.flag)}",
    state.DrawValue: lambda model: f"the drawn {named(model.draw)}",
    state.WordValue: lambda model: named(model.word) + (f" of {named(model.of)}" if model.of else ""),
    state.PositionValue: lambda model: f"position of {named(model.position_of)}",
}
