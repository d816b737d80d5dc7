"""Where rules put things by chance or at a point: each place once, with all that is put there."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from rcj_challenges.scenario.models.actions import Place, Remove
from rcj_challenges.scenario.models.base import Names
from rcj_challenges.scenario.models.places import At, AtPoint, Choice, OnLine, UniformIn
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.views.drawing.labels import Point
from rcj_challenges.views.drawing.shapes import point_words


@dataclass(frozen=True)
class Area:
    """A place of the field that is no spot and no start.

    Attributes:
        at: a zone or a line, every point of which is equally likely, or a point.
        noise_m: half width of the noise around it, in x and y.
    """

    at: UniformIn | OnLine | Point
    noise_m: Point

    def words(self) -> str:
        """Return where it is: ``(0, 0.1)``, ``(-0.3, 0) to (0.3, 0)``, ``in garden``."""
        noise = f", ± {self.noise_m[0]:g}, {self.noise_m[1]:g}" if any(self.noise_m) else ""
        if isinstance(self.at, UniformIn):
            return f"in {self.at.uniform_in}{noise}"
        if isinstance(self.at, OnLine):
            return " to ".join(map(point_words, self.at.on_line)) + noise
        return point_words(self.at) + noise


def placement_areas(scenario: Scenario) -> dict[Area, list[str]]:
    """Return the places where layouts and rules put things, with the names of what is put there, as written."""
    found: dict[Area, list[str]] = {}
    for names, at, noise_m in _placings(scenario):
        for place in _areas(scenario, at):
            who = found.setdefault(Area(place, noise_m), [])
            who.extend(name for name in names if name not in who)
    return found


def _placings(scenario: Scenario) -> Iterator[tuple[tuple[str, ...], At | None, Point]]:
    for layout in scenario.placements.values():
        for placing in layout:
            yield _listed(placing.entity, ""), placing.at, placing.noise_m
    for rule in scenario.rules.values():
        for action in rule.actions:
            if isinstance(action, Place) and action.entity is not None:
                yield _listed(action.entity, rule.for_each or ""), action.at, action.noise_m
            elif isinstance(action, Remove) and action.for_s is not None:
                yield _listed(action.entity, rule.for_each or ""), action.back_at, (0.0, 0.0)


def _listed(names: Names, each: str) -> tuple[str, ...]:
    return tuple(each if name == "each" else name for name in ((names,) if isinstance(names, str) else names))


def _areas(scenario: Scenario, at: At | None) -> Iterator[UniformIn | OnLine | Point]:
    if isinstance(at, OnLine) or (isinstance(at, UniformIn) and at.uniform_in in scenario.zones):
        yield at
    elif isinstance(at, AtPoint):
        yield at.point
    elif isinstance(at, Choice):
        yield from (one for one in at.choice if not isinstance(one, str))
