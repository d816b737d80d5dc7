"""Going through all parts of a scenario's models with the path of each."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any, NamedTuple

from rcj_challenges.scenario.models.base import Strict
from rcj_challenges.scenario.tree import Path


class Found(NamedTuple):
    """A mistake found in the models.

    Attributes:
        path: where it is.
        message: what is wrong.
        at_key: whether it is the key that is wrong.
        other: another place that has part in it: reported there if only that one stands in the author's own file.
    """

    path: Path
    message: str
    at_key: bool = False
    other: Path = ()


def visit(value: Any, path: Path = ()) -> Iterator[tuple[Strict, Path]]:
    """Return every model in a value, itself included, with its path as the file writes it."""
    found: list[tuple[Strict, Path]] = []
    _gather(value, path, found)
    return iter(found)


def _gather(value: Any, path: Path, found: list[tuple[Strict, Path]]) -> None:
    if isinstance(value, Strict):
        found.append((value, path))
        for name, key in _keys(type(value)):
            inner = getattr(value, name)
            if isinstance(inner, _HOLDS_MORE):
                _gather(inner, (*path, key), found)
    elif isinstance(value, dict):
        for key, inner in value.items():
            if isinstance(inner, _HOLDS_MORE):
                _gather(inner, (*path, key), found)
    elif isinstance(value, tuple):
        for index, inner in enumerate(value):
            if isinstance(inner, _HOLDS_MORE):
                _gather(inner, (*path, index), found)


_HOLDS_MORE = (Strict, dict, tuple)
"""All else is a single value."""


@cache
def _keys(model: type[Strict]) -> tuple[tuple[str, str], ...]:
    """Return the names of a model's fields, each with the key that the file uses."""
    return tuple((name, info.alias or name) for name, info in model.model_fields.items())
