"""Lint of measured numbers that are asked for exactly: they pass by between two ticks."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rcj_challenges.facts.timing import s_from_ticks, ticks_from_s
from rcj_challenges.scenario.lint.suspect import Subject, Suspect
from rcj_challenges.scenario.models.conditions import Distance, Speed, TimerIs, WayIs
from rcj_challenges.scenario.tree import Path

_STANDS_MPS = 0.01
"""What is slower hardly moves: 3 mm in 10 ticks."""


def check_exactly(subject: Subject) -> Iterator[Suspect]:
    """Speeds, distances, ways and times that must equal a number which they hardly ever are."""
    for model, path in subject.models:
        limit = getattr(model, "equals", None)
        if not isinstance(limit, int | float):
            continue
        match model:
            case Speed() if limit == 0:
                reason = "what stands still is pushed or slips a little now and then, and is not at exactly 0 m/s then"
                yield _suspect(path, reason, f"write at_most: {_STANDS_MPS}")
            case Speed():
                yield _suspect(
                    path, "no speed is exactly that for a whole tick, but by chance", "write at_least or at_most"
                )
            case Distance() | WayIs() if limit > 0:  # 0: it is in the zone, it lies where it was put, it has not moved
                reason = "what moves is past it from one tick to the next, hardly ever at exactly that"
                yield _suspect(path, reason, "write at_least or at_most")
            case TimerIs() if limit > 0:
                yield from _between_ticks(limit, path)


def _between_ticks(limit_s: float, path: Path) -> Iterator[Suspect]:
    after_s = s_from_ticks(ticks_from_s(limit_s))
    if not math.isclose(after_s, limit_s, rel_tol=0.0, abs_tol=1e-12):
        before_s = s_from_ticks(ticks_from_s(limit_s) - 1)
        reason = f"no timer ever stands at {limit_s:g} s: after {before_s:g} s, on the next tick, come {after_s:g} s"
        yield _suspect(path, reason, f"write at_least: {limit_s:g}, or equals: {after_s:g}")


def _suspect(path: Path, reason: str, remedy: str) -> Suspect:
    return Suspect("exactly_measured", (*path, "equals"), reason, remedy)
