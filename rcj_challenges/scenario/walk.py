"""Walks through all models of a scenario with the path of each."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cache
from typing import Annotated, Any, Literal, TypeVar, get_args, get_origin

from rcj_challenges.rules.base import Trigger
from rcj_challenges.rules.effects import Effect
from rcj_challenges.rules.fields import Strict
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.tree import Path, Step

_E = TypeVar("_E", bound=Effect)


def walk(value: Any, path: Path = ()) -> Iterator[tuple[Strict, Path]]:
    """Yield every model in a value, itself included, with its path as the file writes it."""
    parts: Iterable[tuple[Step, Any]] = ()
    if isinstance(value, Strict):
        yield value, path
        parts = [(key, getattr(value, name)) for name, key in _keys(type(value))]
    elif isinstance(value, dict):
        parts = value.items()
    elif isinstance(value, tuple):
        parts = enumerate(value)
    for step, inner in parts:
        if isinstance(inner, _HOLDS_MORE):
            yield from walk(inner, (*path, step))


def effects_in(name: str, rule: Rule, kind: type[_E]) -> Iterator[tuple[_E, Path]]:
    """Yield the effects of one kind that a rule has, each with the path of its action."""
    for index, action in enumerate(rule.actions):
        yield from ((one, ("rules", name, "actions", index)) for one in action.effects() if isinstance(one, kind))


def triggers_in(name: str, rule: Rule) -> Iterator[tuple[Trigger, Path]]:
    """Yield the triggers of a rule with their paths."""
    yield from ((trigger, ("rules", name, "triggers", index)) for index, trigger in enumerate(rule.triggers))


_HOLDS_MORE = (Strict, dict, tuple)
"""All else is a single value."""


@cache
def _keys(model: type[Strict]) -> tuple[tuple[str, str], ...]:
    """Return the names of a model's fields that can hold models, each with the key that the file uses."""
    return tuple(
        (name, info.alias or name) for name, info in model.model_fields.items() if _may_hold_models(info.annotation)
    )


def _may_hold_models(annotation: Any) -> bool:
    """Return whether a field's value may be a model or hold some: of every type that is not known to hold none."""
    if annotation in _SINGLE:
        return False
    origin = get_origin(annotation)
    if origin is Annotated:
        return _may_hold_models(get_args(annotation)[0])
    return origin is not Literal and (origin is None or any(_may_hold_models(part) for part in get_args(annotation)))


_SINGLE = (str, int, float, bool, type(None), Ellipsis)
