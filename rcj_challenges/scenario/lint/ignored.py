"""Lint of values that nothing looks at because of what stands, or does not stand, beside them."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.models.actions import Place, Remove
from rcj_challenges.scenario.models.base import Strict
from rcj_challenges.scenario.models.field import Box, Cylinder

_HOW_IT_IS_PUT = ("facing", "noise_m", "min_clearance_m", "max_attempts", "on_failure")


def check_ignored(subject: Subject) -> Iterator[Suspect]:
    """A value that is written and decides nothing."""
    for model, path in subject.models:
        for key, reason, remedy in _ignored(model):
            if key in model.model_fields_set:
                yield Suspect("value_without_effect", (*path, key), reason, remedy, at_key=True)


def _ignored(model: Strict) -> Iterator[tuple[str, str, str]]:
    """Yield the keys of a model that decide nothing, whether they are written or not; why, and what to do."""
    match model:
        case Place(layout=layout) if layout is not None:
            for key in _HOW_IT_IS_PUT:
                why = f"beside a layout '{key}' changes nothing: each of its placements says it for itself"
                yield key, why, "write it in the placements of the layout"
        case Remove(for_s=None):
            for key in ("back_at", "facing"):
                why = f"without for_s '{key}' changes nothing: what is taken off stays off until a rule puts it"
                yield key, why, "write for_s beside it, or leave it out"
        # Who writes that it cannot be moved, as in a variant, knows that.
        case Box(movable=False) | Cylinder(movable=False) if "movable" not in model.model_fields_set:
            why = "the mass of what nobody can push changes nothing"
            yield "mass_kg", why, "write movable: true beside it, or leave it out"
