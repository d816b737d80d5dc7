"""The place ``spot``."""

from typing import Annotated

from rcj_challenges.rules.base import Phrases, PlaceResolver, PlaceWord, Scope
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.refs import MOVING, Ref

_SPOT = Ref(
    "spot",
    frozenset({"spot"}),
    drawn=True,
    instead="beside what moves is {relative_to: NAME, offset_m: [0.1, 0]}",
    instead_of=MOVING,
)


class AtSpot(PlaceWord):
    """A spot, referred to by name."""

    spot: Annotated[Name, _SPOT] = described(..., "name of the spot, or of a draw that selects one")

    KEY = "spot"
    EXAMPLE = """
spots:
  mark: {x_m: 0.5, y_m: -0.1}
rules:
  put:
    triggers: [{trigger: time_reached, at_s: 1}]
    actions: [{action: place, entity: ball, at: {spot: mark}}]
expect:
  it_lies_there:
    keyframes: [{at_s: 1}]
    lasts_s: 2
    poses: {ball: [0.5, -0.1]}
"""

    def compile(self, to: Scope, _entity: int) -> PlaceResolver:
        read = to.locate(self.spot)
        return PlaceResolver(lambda request: request.mirrored(read()))

    def fixed(self) -> Name:
        return self.spot

    def describe(self, phrases: Phrases) -> str:
        return f"on {phrases.thing(self.spot)}"
