"""Mistakes in guidelines: drives, devices and fields that do not exist, and prices out of order."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise

from rcj_challenges.chassis.base import CHASSIS
from rcj_challenges.core.diagnostics import Diagnostic, issue
from rcj_challenges.devices.base import DEVICES
from rcj_challenges.rules.base import Vocabulary
from rcj_challenges.scenario.codes import UNKNOWN_NAME, UNKNOWN_WORD, WRONG_VALUE
from rcj_challenges.scenario.errors import choice_of
from rcj_challenges.scenario.models.designs import Guideline, Part
from rcj_challenges.scenario.tree import Path


def check_guideline(guideline: Guideline, path: Path) -> Iterator[Diagnostic]:
    """Yield the mistakes in a guideline."""
    yield from _parts(guideline.drives, CHASSIS, (*path, "drives"))
    yield from _parts(guideline.devices, DEVICES, (*path, "devices"))


def _parts(parts: Mapping[str, Part], words: Vocabulary, path: Path) -> Iterator[Diagnostic]:
    known = {word.name(): word for word in words.words()}
    for name, part in parts.items():
        if name not in known:
            message = f"there is no {words.key} '{name}'"
            yield issue(UNKNOWN_WORD, (*path, name), message, choice_of(name, known), at_key=True)
            continue
        fields = [field for field in known[name].model_fields if field != words.key]
        for field, allowance in part.limits.items():
            at: Path = (*path, name, "limits", field)
            if field not in fields:
                message = f"{name} has no field '{field}'"
                yield issue(UNKNOWN_NAME, at, message, choice_of(field, fields), at_key=True)
            steps = [up_to for up_to, _ in allowance.prices]
            if any(one >= other for one, other in pairwise(steps)):
                yield issue(WRONG_VALUE, (*at, "prices"), "the values must increase from step to step")
