"""The place ``point``."""

from rcj_challenges.rules.base import Phrases, PlaceResolver, PlaceWord, Scope
from rcj_challenges.rules.fields import Point, described


class AtPoint(PlaceWord):
    """A fixed point on the floor."""

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

    def compile(self, _to: Scope, _entity: int) -> PlaceResolver:
        return PlaceResolver(lambda request: request.mirrored(self.point))

    def describe(self, phrases: Phrases) -> str:
        return f"at {phrases.point(self.point)}"

    def aim(self, phrases: Phrases) -> str:
        return phrases.point(self.point)

    def fixed(self) -> Point:
        return self.point

    def options(self) -> tuple[Point, ...]:
        return (self.point,)
