"""Distances that rules measure from things that do not move."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from rcj_challenges.rules.conditions.distance import Distance
from rcj_challenges.rules.conditions.spot_free import SpotFree
from rcj_challenges.rules.triggers.displaced import Displaced
from rcj_challenges.scenario.models.field import Wall
from rcj_challenges.scenario.models.scenario import Rule, Scenario
from rcj_challenges.scenario.roster import Roster, as_tuple, with_each
from rcj_challenges.scenario.walk import walk
from rcj_challenges.views.drawing.shapes import Point, point_words


class MeasuredDistance(NamedTuple):
    """A circle around a spot or a point, or the surroundings of a zone, a gate or a wall.

    Attributes:
        radius_m: the distance that a rule compares with, in m.
        name: of the spot, the zone, the gate or the fixed obstacle; empty for a point.
        centre_m: the circle's centre, [x, y] in m; of a spot that rules set, where it is when a half starts. None of a
            zone, a gate and a wall.
    """

    radius_m: float
    name: str
    centre_m: Point | None = None

    def words(self, unit: str = "") -> str:
        """Return it for the legend: ``0.2 from hill``."""
        return f"{self.radius_m:g}{unit} from {self.name or point_words(self.centre_m or (0.0, 0.0))}"


def measured_distances(scenario: Scenario, roster: Roster) -> list[MeasuredDistance]:
    """Return the distances that rules measure from things that do not move, each once, in the order of the rules.

    Distances that a counter decides are not among them.
    """
    return list(dict.fromkeys(found for rule in scenario.rules.values() for found in _of_rule(rule, scenario, roster)))


def _of_rule(rule: Rule, scenario: Scenario, roster: Roster) -> Iterator[MeasuredDistance]:
    for model, _ in walk(rule):
        if isinstance(model, Distance):
            bounds = (model.at_least, model.at_most, model.equals)
            radii_m = [float(bound) for bound in bounds if isinstance(bound, int | float) and bound > 0]
            for name, centre in _places(model.to, rule, scenario, roster):
                yield from (MeasuredDistance(radius_m, name, centre) for radius_m in radii_m)
        elif isinstance(model, SpotFree) and model.clearance_m > 0:
            for name, centre in (
                place for one in as_tuple(model.spot) for place in _places(one, rule, scenario, roster)
            ):
                yield MeasuredDistance(model.clearance_m, name, centre)
        elif isinstance(model, Displaced) and not isinstance(model.from_, str) and model.axis == "distance":
            yield MeasuredDistance(model.distance_m, "", model.from_)


def _places(to: str | Point, rule: Rule, scenario: Scenario, roster: Roster) -> Iterator[tuple[str, Point | None]]:
    """Yield what stands still of what a name stands for, or the point; with where it is, if it has a centre."""
    if not isinstance(to, str):
        yield "", to
        return
    for name in roster.may_be(with_each(to, rule.for_each)):
        if name in scenario.spots:
            spot = scenario.spots[name]
            yield name, (spot.x_m, spot.y_m)
        elif name in scenario.obstacles and name not in roster.entities:
            obstacle = scenario.obstacles[name]
            yield name, None if isinstance(obstacle, Wall) else obstacle.centre_m
        elif name in scenario.zones or (name in scenario.gates and scenario.gates[name].anchor is None):
            yield name, None
