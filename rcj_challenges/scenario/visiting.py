"""Going through all parts of a scenario's models with the path of each."""

from __future__ import annotations

from collections.abc import Iterator
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
    """Yield every model in a value, itself included, with its path as the file writes it."""
    if isinstance(value, Strict):
        yield value, path
        for name, info in type(value).model_fields.items():
            yield from visit(getattr(value, name), (*path, info.alias or name))
    elif isinstance(value, dict):
        for key, inner in value.items():
            yield from visit(inner, (*path, key))
    elif isinstance(value, tuple):
        for index, inner in enumerate(value):
            yield from visit(inner, (*path, index))
