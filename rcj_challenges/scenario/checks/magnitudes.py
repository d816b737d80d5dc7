"""How large and how small numbers may be: what has no place in a hall, and what nothing here could build or count.

Not bounds of the models: what an older version took can still be read in a record.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any

from rcj_challenges.chassis.base import Chassis
from rcj_challenges.core.diagnostics import Diagnostic, issue
from rcj_challenges.rules.actions.count import Count
from rcj_challenges.rules.fields import LONGEST_S, Strict
from rcj_challenges.scenario.codes import OUT_OF_RANGE
from rcj_challenges.scenario.models.field import Ball, Box, Cylinder, FieldModel, Goal, Wall
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.tree import Path
from rcj_challenges.scenario.walk import walk

MAX_NOISE_M = 5.0
"""Half of the largest field: from anywhere on it a place may be noised to anywhere else."""
FARTHEST_M = 1000.0
"""A hundred times the largest field, for zones that shall have no end; squares of it are far from any overflow."""
MAX_RAD = 1000.0
"""159 turns; angles are kept as float32, and of a much larger one no digit would tell the direction."""
MAX_SHARE = 1000.0
"""Of a noise as a share of what is measured: nothing of that is left at a hundredth of it."""
SMALLEST_M, LARGEST_M = 0.001, 10.0
"""Of bodies, walls and goals: a millimetre, which contacts still resolve, to the largest field."""
LIGHTEST_KG = 1e-6
"""A milligram."""

_BODIES = (Ball, Box, Cylinder, Wall, Goal, FieldModel)
_SIZES = frozenset({"size_m", "radius_m", "height_m", "thickness_m", "width_m", "length_m", "depth_m", "wall_height_m"})
_PLACES = frozenset({"point", "on_line", "choice", "to", "from_", "towards", "distance", "tells"})
"""Fields that may hold points, and do not say so by their unit."""
_Range = tuple[float, float, str]
_ANGLE: _Range = (-MAX_RAD, MAX_RAD, " rad")
_BY_NAME: dict[str, _Range] = {
    "noise_m": (0.0, MAX_NOISE_M, " m"),
    # Durations that may be 0; all others have their bounds in the models.
    **dict.fromkeys(("for_s", "grace_s"), (0.0, LONGEST_S, " s")),
    "facing": _ANGLE,
    # Of a keyframe: x and y in m, and yaw in rad.
    **dict.fromkeys(("place", "move"), (-FARTHEST_M, FARTHEST_M, "")),
    **dict.fromkeys(("noise", "strength_noise"), (0.0, MAX_SHARE, "")),
}


def check_magnitudes(scenario: Scenario) -> Iterator[Diagnostic]:
    """Yield the lengths, coordinates, angles, durations, noises and masses that are too large or too small."""
    for model, path in walk(scenario):
        for name, key, (least, most, unit) in _bounded(type(model)):
            numbers = _numbers(getattr(model, name), (*path, key))
            wrong = next(((number, at) for number, at in numbers if not least <= number <= most), None)
            if wrong is not None:  # the first of a point or a list is enough
                bound = f"at least {least:g}" if wrong[0] < least else f"at most {most:g}"
                yield issue(OUT_OF_RANGE, wrong[1], f"{key} must be {bound}{unit}, found {wrong[0]:g}")


@cache
def _bounded(model: type[Strict]) -> tuple[tuple[str, str, _Range], ...]:
    """Return the fields of a model that have bounds here: name, key in the file, least, most and unit."""
    found = ((name, info.alias or name, _range(model, name)) for name, info in model.model_fields.items())
    return tuple((name, key, bounds) for name, key, bounds in found if bounds is not None)


def _range(model: type[Strict], name: str) -> _Range | None:
    if name.endswith("mass_kg"):
        return LIGHTEST_KG, float("inf"), " kg"
    if name in _BY_NAME:
        return _BY_NAME[name]
    if name.endswith("_rad"):
        return _ANGLE
    if (issubclass(model, Chassis) and name.endswith("_m")) or (model in _BODIES and name in _SIZES):
        return SMALLEST_M, LARGEST_M, " m"
    holds_points = name in _PLACES and model is not Count  # whose `to` is a number of anything
    return (-FARTHEST_M, FARTHEST_M, " m") if name.endswith("_m") or holds_points else None


def _numbers(value: Any, path: Path) -> Iterator[tuple[float, Path]]:
    """Yield the numbers of a value, also of points and of lists of them; models in it are looked at by themselves."""
    if isinstance(value, int | float):
        yield value, path
    elif isinstance(value, tuple | dict):
        for step, inner in value.items() if isinstance(value, dict) else enumerate(value):
            yield from _numbers(inner, (*path, step))
