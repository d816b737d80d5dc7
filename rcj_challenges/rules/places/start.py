"""The place ``start``."""

from rcj_challenges.rules.base import Phrases, PlaceResolver, PlaceWord, Scope
from rcj_challenges.rules.fields import Names, Yes


class Start(PlaceWord):
    """The entity's own start pose, with its noise."""

    start: Yes

    KEY = "start"
    EXAMPLE = """
rules:
  home:
    triggers: [{trigger: time_reached, at_s: 1}]
    actions: [{action: place, entity: robots, at: start}]
expect:
  y1_is_near_its_start_again:
    keyframes: [{at_s: 0.5, place: {Y1: [0.5, 0]}}]
    lasts_s: 2
    poses: {Y1: [-0.3, -0.3]}
    tolerance_m: 0.11
"""

    def compile(self, to: Scope, entity: int) -> PlaceResolver:
        (x, y, _), noise_m = to.start_of(entity)
        return PlaceResolver(lambda request: request.mirrored((x, y)), noise_m=noise_m)

    def describe(self, _phrases: Phrases) -> str:
        return "at its start"

    def aim(self, _phrases: Phrases) -> str:
        return "its start"

    def options(self) -> tuple[()]:
        return ()

    def describe_placement(self, phrases: Phrases, entity: Names, *, plural: bool) -> str:
        return "put at their starts" if plural else super().describe_placement(phrases, entity, plural=plural)
