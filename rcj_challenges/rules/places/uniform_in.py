"""The place ``uniform_in``."""

from collections.abc import Callable
from random import Random
from typing import Annotated

from rcj_challenges.rules.base import Phrases, Scope
from rcj_challenges.rules.fields import Names, Point, described
from rcj_challenges.rules.places.apart import RandomPlace
from rcj_challenges.rules.refs import Ref


class UniformIn(RandomPlace):
    """A random point in a zone or in the union of several; all points are equally likely."""

    uniform_in: Annotated[Names, Ref("zone", frozenset({"zone"}), groups=True)] = described(
        ..., "a bounded zone; with a list or group: in any of them"
    )

    KEY = "uniform_in"
    IS_SPREAD = True
    EXAMPLE = """
zones:
  middle: {shape: circle, centre_m: [0.4, 0], radius_m: 0.1}
rules:
  put:
    triggers: [{trigger: time_reached, at_s: 1}]
    actions: [{action: place, entity: ball, at: {uniform_in: middle}, min_clearance_m: 0.02}]
expect:
  somewhere_in_the_circle:
    keyframes: [{at_s: 1}]
    lasts_s: 2
    poses: {ball: [0.4, 0]}
    tolerance_m: 0.1
"""

    def sampler(self, to: Scope) -> Callable[[Random], Point]:
        return to.random_point(self.uniform_in)

    def describe(self, phrases: Phrases) -> str:
        return self.with_distance(f"anywhere in {phrases.any_of(self.uniform_in)}", phrases)

    def aim(self, phrases: Phrases) -> str:
        return self.with_distance(f"a random point of {phrases.any_of(self.uniform_in)}", phrases)
