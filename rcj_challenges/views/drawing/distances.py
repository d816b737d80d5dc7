"""Distances that rules measure from spots and points."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from rcj_challenges.rules.base import Word
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.roster import Roster, with_each
from rcj_challenges.scenario.shapes import Point, point_words
from rcj_challenges.scenario.walk import walk


class MeasuredDistance(NamedTuple):
    """A circle around a spot or a point.

    Attributes:
        radius_m: the distance that a rule compares with, in m.
        name: of the spot; empty for a point.
        centre_m: of the circle; of a spot that rules set, where it is when a half starts.
    """

    radius_m: float
    name: str
    centre_m: Point

    def words(self, unit: str = "") -> str:
        """Return it for the legend: ``0.2 from hill``."""
        return f"{self.radius_m:g}{unit} from {self.name or point_words(self.centre_m)}"


def measured_distances(scenario: Scenario, roster: Roster) -> list[MeasuredDistance]:
    """Return the distances that rules measure from spots and points, each once, in the order of the rules."""
    return list(dict.fromkeys(found for rule in scenario.rules.values() for found in _of_rule(rule, scenario, roster)))


def _of_rule(rule: Rule, scenario: Scenario, roster: Roster) -> Iterator[MeasuredDistance]:
    words = (word for word, _ in walk(rule) if isinstance(word, Word))
    for origin, radius_m in (pair for word in words for pair in word.distances_m()):
        if not isinstance(origin, str):
            yield MeasuredDistance(radius_m, "", origin)
            continue
        for name in roster.may_be(with_each(origin, rule.for_each)):
            if name in scenario.spots:
                spot = scenario.spots[name]
                yield MeasuredDistance(radius_m, name, (spot.x_m, spot.y_m))
