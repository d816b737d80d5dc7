"""A place that the package does not have."""

from math import cos, sin, tau
from typing import Annotated

from rcj_challenges.rules.base import Phrases, PlaceRequest, PlaceResolver, PlaceWord, Scope
from rcj_challenges.rules.fields import Name, Point, Positive, described
from rcj_challenges.rules.phrasing import metres
from rcj_challenges.rules.refs import ANCHOR
from rcj_challenges.tracking.places import point_of


class OnCircle(PlaceWord):
    """A random point of a circle around something."""

    on_circle: Annotated[Name, ANCHOR] = described(..., "around what")
    radius_m: Positive = described(..., "radius in m")

    KEY = "on_circle"
    EXAMPLE = """
rules:
  drop:
    triggers: [{trigger: time_reached, at_s: 1}]
    actions: [{action: place, entity: ball, at: {on_circle: middle_yellow, radius_m: 0.1}}]
  near:
    triggers: [{trigger: time_reached, at_s: 2}]
    conditions: [{distance: [ball, middle_yellow], at_least: 0.099, at_most: 0.101}]
    actions: [{action: emit, event: NEAR}]
expect:
  it_lies_on_the_circle:
    keyframes: [{at_s: 0, place: {Y1: [0.5, 0], Y2: [0.5, 0.3], Y3: [0.5, -0.3]}}]
    lasts_s: 3
    events: [{event: NEAR}]
"""

    def compile(self, to: Scope, _entity: int) -> PlaceResolver:
        """Return what draws a point."""
        centre, radius_m = to.anchor(self.on_circle), self.radius_m

        def find(request: PlaceRequest) -> Point:
            turn, (x, y) = request.rng.uniform(0, tau), point_of(centre(), request.board)
            return request.mirrored((x + radius_m * cos(turn), y + radius_m * sin(turn)))

        return PlaceResolver(find, random=True)

    def describe(self, phrases: Phrases) -> str:
        """Return the place as the part of a sentence that follows ``put``."""
        return f"anywhere {metres(self.radius_m)} from {phrases.thing(self.on_circle)}"
