"""The place ``point``."""

from rcj_challenges.rules.base import PlaceWord
from rcj_challenges.rules.binder import Scope
from rcj_challenges.rules.fields import Point, described
from rcj_challenges.rules.phrases import Phrases
from rcj_challenges.tracking.places import PlaceResolver


class AtPoint(PlaceWord):
    """A fixed point of the floor."""

    point: Point = described(..., "[x, y] in m")

    KEY = "point"
    EXAMPLE = """
rules:
  put:
    triggers: [{trigger: time_reached, at_s: 1}]
    actions: [{action: place, entity: ball, at: {point: [0.4, 0.1]}}]
expect:
  it_lies_there:
    keyframes: [{at_s: 1}]
    lasts_s: 2
    poses: {ball: [0.4, 0.1]}
"""
    SENTENCE = "at (0.4, 0.1)"

    def compile(self, _to: Scope, _entity: int) -> PlaceResolver:
        """Return what finds the point."""
        return PlaceResolver(lambda request: request.mirrored(self.point))

    def describe(self, phrases: Phrases) -> str:
        """Return the place as the part of a sentence that follows ``put``."""
        return f"at {phrases.point(self.point)}"

    def aim(self, phrases: Phrases) -> str:
        """Return the place as what a kick is aimed at."""
        return phrases.point(self.point)
