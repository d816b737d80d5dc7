"""Lint of kicks: a ball that is aimed at the very place where it is put."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.models import places
from rcj_challenges.scenario.models.actions import Place

_FIXED = (str, places.Start, places.AtPoint, places.AtSpot, places.RelativeTo)
"""The words of ``at`` that always give one and the same place; noise may still move what is put there."""


def check_kicks(subject: Subject) -> Iterator[Suspect]:
    """A kick that has no way to go."""
    for model, path in subject.models:
        if not isinstance(model, Place | places.Placing) or model.kick is None or any(model.noise_m):
            continue
        if isinstance(model.at, _FIXED) and model.at == model.kick.towards:
            yield Suspect(
                "kick_without_a_way",
                (*path, "kick", "towards"),
                "the ball is aimed at the place where it is put: it has no way to go and lies still",
                "aim it elsewhere, or leave kick out",
            )
