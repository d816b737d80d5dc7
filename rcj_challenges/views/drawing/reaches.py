"""Distances that rules measure from places that stand still: circles in the drawing, numbers in its legend."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from rcj_challenges.scenario.models.conditions import Distance
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.models.triggers import Displaced
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.visiting import visit
from rcj_challenges.views.drawing.labels import Point
from rcj_challenges.views.drawing.shapes import point_words


class Reach(NamedTuple):
    """A circle around a spot or a point.

    Attributes:
        centre_m: its centre, [x, y] in m; of a spot that rules set, where it is when a half starts.
        radius_m: the distance that a rule compares with, in m.
        spot: the name of the spot; empty for a point.
    """

    centre_m: Point
    radius_m: float
    spot: str

    def words(self, unit: str = "") -> str:
        """Return it for the legend: ``0.2 from hill``."""
        return f"{self.radius_m:g}{unit} from {self.spot or point_words(self.centre_m)}"


def reaches(scenario: Scenario, roster: Roster) -> list[Reach]:
    """Return what rules measure from spots and points, each circle once, in the order of the rules.

    What is measured from something that moves, or against a counter, has no place of its own and is left out.
    """
    return list(dict.fromkeys(reach for rule in scenario.rules.values() for reach in _of_rule(rule, scenario, roster)))


def _of_rule(rule: object, scenario: Scenario, roster: Roster) -> Iterator[Reach]:
    for model, _ in visit(rule):
        if isinstance(model, Distance):
            bounds = (model.at_least, model.at_most, model.equals)
            for spot, centre in _places(model.to, scenario, roster):
                yield from (Reach(centre, one, spot) for one in bounds if isinstance(one, int | float) and one > 0)
        elif isinstance(model, Displaced) and not isinstance(model.from_, str) and model.axis == "distance":
            yield Reach(model.from_, model.distance_m, "")


def _places(to: str | Point, scenario: Scenario, roster: Roster) -> Iterator[tuple[str, Point]]:
    """Yield the spots that a name stands for, or the point, with where they are."""
    if not isinstance(to, str):
        yield "", to
        return
    for name in roster.expand(to):
        if name in scenario.spots:
            spot = scenario.spots[name]
            yield name, (spot.x_m, spot.y_m)
