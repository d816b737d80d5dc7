"""The place ``choice``."""

from typing import Annotated

from rcj_challenges.rules.base import Phrases, PlaceResolver, Scope
from rcj_challenges.rules.fields import Name, Point, described
from rcj_challenges.rules.phrasing import listed
from rcj_challenges.rules.places.apart import RandomPlace
from rcj_challenges.rules.refs import Ref


class Choice(RandomPlace):
    """One of several spots or points, chosen with equal probability, or the one that a draw selected."""

    choice: Annotated[tuple[Name | Point, ...], Ref("spot", frozenset({"spot"}), groups=True, drawn=True)] = described(
        ..., "spots, groups of spots, draws that select a spot, or points", min_length=1
    )

    KEY = "choice"
    EXAMPLE = """
rules:
  put:
    triggers: [{trigger: half_started}]
    actions: [{action: place, entity: ball, at: {choice: [[0.5, 0], [0.5, 0.1]]}}]
expect:
  one_of_the_two:
    keyframes: [{at_s: 1}]
    lasts_s: 2
    poses: {ball: [0.5, 0.05]}
    tolerance_m: 0.051
"""

    def compile(self, to: Scope, _entity: int) -> PlaceResolver:
        """Return a function that draws a spot or point; a draw among them stands for the spot that it decided."""
        named = ((one,) if isinstance(one, tuple) else to.members(one) for one in self.choice)
        options = [to.locate(option) for one in named for option in one]
        return PlaceResolver(self.finder(to, lambda rng: rng.choice(options)()), random=len(options) > 1)

    def describe(self, phrases: Phrases) -> str:
        options = [phrases.any_of(one) if isinstance(one, str) else phrases.point(one) for one in self.choice]
        return self.with_distance(f"on {listed(options, 'or')}", phrases)
