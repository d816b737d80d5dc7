"""Lint of times: limits that a half is too short for, halves that are not played."""

from __future__ import annotations

from collections.abc import Iterator

from rcj_challenges.facts.timing import ticks_from_s
from rcj_challenges.scenario.lint_suspect import Subject, Suspect, lengths_s
from rcj_challenges.scenario.models.actions import Remove
from rcj_challenges.scenario.models.base import Strict
from rcj_challenges.scenario.models.conditions import HalfIs
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.models.state import DrawnDuration, Phase, Timer
from rcj_challenges.scenario.models.triggers import Holds, NoProgress, StaysIn, Touches

_NEVER = "it never fires"


def check_times(subject: Subject) -> Iterator[Suspect]:
    """Limits that are not over before the half is."""
    half_s = subject.scenario.match.half_s
    half = ticks_from_s(half_s)
    for model, path in subject.models:
        for key, seconds, strict, consequence in _limits(model, subject.scenario):
            ticks = ticks_from_s(seconds) if seconds else 0
            if ticks > half or (strict and ticks == half):
                yield Suspect(
                    "limit_longer_than_the_half",
                    (*path, key),
                    f"{seconds:g} s is not over before the half is, after {half_s:g} s: {consequence}",
                    "shorten it, or lengthen match.half_s",
                )


def check_halves(subject: Subject) -> Iterator[Suspect]:
    """Conditions on a half that is not played."""
    halves = subject.scenario.match.halves
    for model, path in subject.models:
        if isinstance(model, HalfIs) and (model.equals or model.at_least or 1) > halves:
            played = "one half is" if halves == 1 else f"{halves} halves are"
            yield Suspect(
                "half_never_played",
                path,
                f"only {played} played: the condition {'always' if model.negate else 'never'} holds",
                "correct the number of the half, or raise match.halves",
            )


def _limits(model: Strict, scenario: Scenario) -> Iterator[tuple[str, float, bool, str]]:
    """Yield key, seconds, whether it must be strictly shorter than the half, and what follows if it is not."""
    match model:
        case StaysIn():
            yield "limit_s", model.limit_s, True, _NEVER
        case NoProgress():
            yield "within_s", model.within_s, True, _NEVER
        case Holds():
            yield "for_s", model.for_s, True, _NEVER
        case Touches() if model.every_s is not None:
            yield "every_s", model.every_s, False, "it fires when the touch begins only (leave it out)"
        case Timer():
            yield _lasting(model.lasts_s, scenario, "it never expires")
        case Phase() if model.lasts_s is not None:
            yield _lasting(model.lasts_s, scenario, "the phase never ends by itself")
        case Remove() if model.for_s is not None:
            yield "for_s", model.for_s, False, "what is taken off does not come back"
        case Rule() if model.cooldown_s is not None:
            yield "cooldown_s", model.cooldown_s, False, "the rule fires once (max_executions: 1 says so)"


def _lasting(lasts_s: float | DrawnDuration, scenario: Scenario, consequence: str) -> tuple[str, float, bool, str]:
    """Return the same of what lasts a time: of one that is drawn the longest."""
    if isinstance(lasts_s, DrawnDuration):
        return "lasts_s", max(lengths_s(lasts_s, scenario)), False, f"{consequence} when that is drawn"
    return "lasts_s", lasts_s, False, consequence
