"""Lint of angles that are more than a full turn: hardly anybody means them in rad."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi, radians

from rcj_challenges.scenario.lint_suspect import Subject, Suspect

_UNIT = "_rad"
_WITHOUT_UNIT = "facing"
"""The one angle whose key does not tell its unit, for it need not be a number."""


def check_angles(subject: Subject) -> Iterator[Suspect]:
    """Angles of more than a turn, which are degrees."""
    for model, path in subject.models:
        for name in type(model).model_fields:
            value = getattr(model, name)
            if not (name.endswith(_UNIT) or name == _WITHOUT_UNIT) or not isinstance(value, int | float):
                continue
            if abs(value) > 2 * pi:
                yield Suspect(
                    "angle_in_degrees",
                    (*path, name),
                    f"angles are in rad, and {value:g} rad are more than a full turn, which is {2 * pi:.4f}",
                    f"if degrees are meant, write {radians(value):.4f}; else write the angle without the full turns",
                )
