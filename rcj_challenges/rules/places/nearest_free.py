"""The place ``nearest_free``."""

from typing import Annotated

from rcj_challenges.rules.base import Phrases, PlaceResolver, PlaceWord, Scope
from rcj_challenges.rules.fields import Name, Names, NotNegative, Point, described
from rcj_challenges.rules.phrasing import FREE_SPOT_NOTE, USUALLY_FREE_M
from rcj_challenges.rules.places.free_spots import CLEARANCE_DESCRIPTION, compile_free_spot, describe_free_spot
from rcj_challenges.rules.refs import ANCHOR, SPOTS


class NearestFree(PlaceWord):
    """The nearest free spot, or one chosen at random among the nearest."""

    nearest_free: Annotated[Names, SPOTS] = described(..., "spots, or a group of spots")
    to: Annotated[Name | Point | None, ANCHOR] = described(
        None, "what to be near: an entity, spot, point, each, or a draw's name; if omitted: the entity being placed"
    )
    choose_among: int = described(1, "choose at random among this many of the nearest", ge=1, le=100)
    clearance_m: NotNegative = described(USUALLY_FREE_M, CLEARANCE_DESCRIPTION)

    KEY = "nearest_free"
    NOTES = (FREE_SPOT_NOTE,)
    EXAMPLE = """
rules:
  put_back:
    triggers: [{trigger: leaves, entity: ball, zone: in_play}]
    actions: [{action: place, entity: ball, at: {nearest_free: neutral_spots, choose_among: 1}}]
expect:
  the_middle_of_yellows_half_is_nearest:
    keyframes:
      - {at_s: 0.5, place: {ball: [0.1, -0.1], Y3: [0.5, 0.5], Y1: [-0.5, 0], Y2: [-0.5, 0.6]}}
      - {at_s: 1, place: {ball: [0, -0.9]}}
    lasts_s: 2
    poses: {ball: [0.3, -0.3]}
    tolerance_m: 0.61
"""
    SENTENCE = "on the free one of the neutral spots that is nearest to where it is"

    def compile(self, to: Scope, _entity: int) -> PlaceResolver:
        return compile_free_spot(self, to, self.nearest_free, self.to, sign=1.0)

    def describe(self, phrases: Phrases) -> str:
        return describe_free_spot(self, phrases, "nearest to", self.nearest_free, self.to)
