"""The blanks of ``says``. What is known before anything happens is filled in here, for sheet and referee alike."""

from __future__ import annotations

import re
from collections.abc import Mapping

from rcj_challenges.facts.amounts import on_paper
from rcj_challenges.scenario.models.actions import Score
from rcj_challenges.scenario.models.base import Scalar
from rcj_challenges.scenario.models.scenario import Rule

BLANKS = ("entity", "each", "other", "team", "measured", "limit", "points")
"""What is filled in when a rule fires. In braces also a param's name; a blank goes before a param of its name."""

_IN_BRACES = re.compile(r"\{([^{}]*)\}")


def in_braces(says: str) -> tuple[str, ...]:
    """Return what stands in braces in a sentence, each once."""
    return tuple(dict.fromkeys(_IN_BRACES.findall(says)))


def points_of(rule: Rule) -> frozenset[float | None]:
    """Return how many points the score actions of a rule give; None stands for what is known only when it fires."""
    given = (action.points for action in rule.actions if isinstance(action, Score))
    return frozenset(points if isinstance(points, int | float) else None for points in given)


def partly_filled(rule: Rule, params: Mapping[str, Scalar]) -> str:
    """Return what a rule says, with its params filled in, and its points if it gives one plain number."""
    known = {name: _as_text(value) for name, value in params.items() if name not in BLANKS}
    points = points_of(rule)
    number = next(iter(points)) if len(points) == 1 else None
    if number is not None:
        known["points"] = _as_text(number)
    return _IN_BRACES.sub(lambda blank: known.get(blank[1], blank[0]), rule.says)


def _as_text(value: Scalar) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    return str(on_paper(value)) if isinstance(value, int | float) else value
