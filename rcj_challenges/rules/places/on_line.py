"""The place ``on_line``."""

from collections.abc import Callable
from random import Random

from pydantic import Field

from rcj_challenges.rules.base import Phrases, PlaceResolver, PlaceWord, Scope
from rcj_challenges.rules.fields import Point


class OnLine(PlaceWord):
    """A random point on a line segment; all points are equally likely."""

    on_line: tuple[Point, Point] = Field(..., strict=False, description="both ends, [[x, y], [x, y]] in m")

    KEY = "on_line"
    IS_SPREAD = True
    EXAMPLE = """
rules:
  put:
    triggers: [{trigger: half_started}]
    actions: [{action: place, entity: ball, at: {on_line: [[-0.45, 0], [0.45, 0]]}}]
expect:
  somewhere_on_the_line:
    keyframes: [{at_s: 1}]
    lasts_s: 2
    poses: {ball: [0, 0]}
    tolerance_m: 0.45
"""
    SENTENCE = "anywhere on the line from (-0.45, 0) to (0.45, 0)"

    def compile(self, to: Scope, _entity: int) -> PlaceResolver:
        sample = self.sampler(to)
        return PlaceResolver(lambda request: request.mirrored(sample(request.rng)), random=True)

    def sampler(self, _to: Scope) -> Callable[[Random], Point]:
        (ax, ay), (bx, by) = self.on_line

        def sample(rng: Random) -> Point:
            share = rng.random()
            return (ax + share * (bx - ax), ay + share * (by - ay))

        return sample

    def describe(self, phrases: Phrases) -> str:
        return f"anywhere on {self._line(phrases)}"

    def aim(self, phrases: Phrases) -> str:
        return f"a random point of {self._line(phrases)}"

    def _line(self, phrases: Phrases) -> str:
        start, end = map(phrases.point, self.on_line)
        return f"the line from {start} to {end}"
