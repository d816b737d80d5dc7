"""Lint of angles that are more than a full turn: hardly anybody means them in rad."""

from __future__ import annotations

from collections.abc import Iterator
from math import pi, radians

from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.models.base import Strict
from rcj_challenges.scenario.models.scenario import Keyframe
from rcj_challenges.scenario.tree import Path

_UNIT = "_rad"
_WITHOUT_UNIT = "facing"
"""The one angle whose key does not tell its unit, for it need not be a number."""
_YAW = 2
"""Where the angle stands in [x, y, yaw]."""
_FULL_TURN_RAD = 6.3
"""As anybody may round it: 6.2832, 6.284, 6.3."""


def check_angles(subject: Subject) -> Iterator[Suspect]:
    """Angles of more than a turn, which are degrees."""
    for model, path in subject.models:
        for angle_rad, at in _angles(model, path):
            if abs(angle_rad) > _FULL_TURN_RAD:
                yield Suspect(
                    "angle_in_degrees",
                    at,
                    f"angles are in rad, and {angle_rad:g} rad are more than a full turn, which is {2 * pi:.4f}",
                    f"if degrees are meant, write {radians(angle_rad):.4f}; else leave the full turns out",
                )


def _angles(model: Strict, path: Path) -> Iterator[tuple[float, Path]]:
    for name in type(model).model_fields:
        value = getattr(model, name)
        if (name.endswith(_UNIT) or name == _WITHOUT_UNIT) and isinstance(value, int | float):
            yield value, (*path, name)
    if isinstance(model, Keyframe):
        for key, poses in (("place", model.place), ("move", model.move)):
            for entity, pose in poses.items():
                if len(pose) > _YAW:
                    yield pose[_YAW], (*path, key, entity, _YAW)
