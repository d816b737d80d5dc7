"""The blanks of ``says``, and params in the description: what is known before anything happens is filled in here."""

from __future__ import annotations

import re
from collections.abc import Mapping

from rcj_challenges.facts.amounts import round_score
from rcj_challenges.facts.measures import number_words
from rcj_challenges.rules.actions.score import Score
from rcj_challenges.rules.fields import Scalar
from rcj_challenges.scenario.models.scenario import Rule, Scenario

BLANKS = ("entity", "each", "other", "team", "measured", "limit", "points")
"""What is filled in when a rule fires. In braces also a param's name; a blank goes before a param of its name."""

_IN_BRACES = re.compile(r"\{([^{}]*)\}")
_OF_POINTS = re.compile(r"\{([^{}]*)\}( points\b)?")
_ONE = ("1", "-1")
_DECIMALS = 9  # to so many numbers are exact


def in_braces(says: str) -> tuple[str, ...]:
    """Return what stands in braces in a sentence, each once."""
    return tuple(dict.fromkeys(_IN_BRACES.findall(says)))


def points_of(rule: Rule) -> frozenset[float | None]:
    """Return how many points the score actions of a rule give; None stands for what is known only when it fires."""
    return frozenset(_points(action) for action in rule.actions if isinstance(action, Score))


def _points(action: Score) -> float | None:
    depends_on_the_score = action.keeps_at_least is not None or action.keeps_at_most is not None
    if not isinstance(action.points, int | float) or depends_on_the_score:
        return None
    least, most = action.at_least, action.at_most
    points = action.points if least is None else max(action.points, least)
    return points if most is None else min(points, most)


def partly_filled(rule: Rule, params: Mapping[str, Scalar]) -> str:
    """Return what a rule says, with its params filled in, and its points if it gives one plain number."""
    known = {name: _as_text(value) for name, value in params.items() if name not in BLANKS}
    points = points_of(rule)
    number = next(iter(points)) if len(points) == 1 else None
    if number is not None:
        known["points"] = _as_text(number)
    return _filled(rule.says, known)


def description_of(scenario: Scenario) -> str:
    """Return what a scenario is about, with the values of its params: it is true for every ``--set``."""
    known = {name: _as_text(value) for name, value in scenario.params.items()}
    return _filled(scenario.description, known)


def counted(number: str) -> str:
    """Return a number of points as people say it: ``1 point``, ``2 points``."""
    return f"{number} point" if number in _ONE else f"{number} points"


def filled(text: str, values: Mapping[str, Scalar | list[Scalar]]) -> str:
    """Return a text with values filled in by their names; what is not known stays as it is."""
    return _filled(text, {name: _enumerated(value) for name, value in values.items()})


def _enumerated(value: Scalar | list[Scalar]) -> str:
    if not isinstance(value, list):
        return _as_text(value)
    words = [_as_text(one) for one in value]
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def _filled(text: str, known: Mapping[str, str]) -> str:
    """Fill in what is known; ``{points} points`` is one point if it is one."""

    def fill(blank: re.Match[str]) -> str:
        value = known.get(blank[1])
        if value is None:
            return blank[0]
        return counted(value) if blank[2] else value

    return _OF_POINTS.sub(fill, text)


def _as_text(value: Scalar) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    return number_words(round_score(value), _DECIMALS) if isinstance(value, int | float) else value
