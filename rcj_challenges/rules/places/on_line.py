"""The place ``on_line``."""

from collections.abc import Callable
from random import Random

from rcj_challenges.rules.base import Phrases, Scope
from rcj_challenges.rules.fields import Point, described
from rcj_challenges.rules.places.apart import RandomPlace


class OnLine(RandomPlace):
    """A random point on a line segment; all points are equally likely."""

    on_line: tuple[Point, Point] = described(..., "both ends, [[x, y], [x, y]] in m")

    KEY = "on_line"
    IS_SPREAD = True
    EXAMPLE = """
rules:
  put:
    triggers: [{trigger: half_started}]
    actions: [{action: place, entity: ball, at: {on_line: [[-0.45, 0], [0.45, 0]], from: robots, at_least_m: 0.25}}]
expect:
  somewhere_on_the_line:
    keyframes: [{at_s: 1}]
    lasts_s: 2
    poses: {ball: [0, 0]}
    tolerance_m: 0.45
"""

    def sampler(self, _to: Scope) -> Callable[[Random], Point]:
        (ax, ay), (bx, by) = self.on_line

        def sample(rng: Random) -> Point:
            share = rng.random()
            return (ax + share * (bx - ax), ay + share * (by - ay))

        return sample

    def describe(self, phrases: Phrases) -> str:
        return self.with_distance(f"anywhere on {self._line(phrases)}", phrases)

    def aim(self, phrases: Phrases) -> str:
        return self.with_distance(f"a random point of {self._line(phrases)}", phrases)

    def _line(self, phrases: Phrases) -> str:
        start, end = map(phrases.point, self.on_line)
        return f"the line from {start} to {end}"
