"""The place ``furthest_free``."""

from typing import Annotated

from pydantic import Field

from rcj_challenges.rules.base import Phrases, PlaceResolver, PlaceWord, Scope
from rcj_challenges.rules.fields import Name, Names, NotNegative, Point, described
from rcj_challenges.rules.phrasing import FREE_SPOT_NOTE, USUALLY_FREE_M
from rcj_challenges.rules.places.free_spots import CLEARANCE_DESCRIPTION, compile_free_spot, describe_free_spot
from rcj_challenges.rules.refs import ANCHOR, SPOTS


class FurthestFree(PlaceWord):
    """The furthest free spot, or one chosen at random among the furthest."""

    furthest_free: Annotated[Names, SPOTS] = described(..., "spots, or a group of spots")
    from_: Annotated[Name | Point | None, ANCHOR] = Field(
        None,
        alias="from",
        description="what to be far from: an entity, spot, point, each, or a draw's name; if omitted: the "
        "entity being placed",
    )
    choose_among: int = described(1, "choose at random among this many of the furthest", ge=1, le=100)
    clearance_m: NotNegative = described(USUALLY_FREE_M, CLEARANCE_DESCRIPTION)

    KEY = "furthest_free"
    NOTES = (FREE_SPOT_NOTE,)
    EXAMPLE = """
rules:
  put_back:
    triggers: [{trigger: touches, entity: Y1, other: walls}]
    actions: [{action: place, entity: Y1, at: {furthest_free: [middle_blue, middle_yellow], from: ball}}]
expect:
  far_from_the_ball:
    keyframes:
      - {at_s: 0.5, place: {ball: [0, 0.6], B3: [0.5, 0], Y3: [0.5, -0.6]}}
      - {at_s: 1, touch: [[Y1, walls]]}
    lasts_s: 2
    poses: {Y1: [0, -0.2]}
"""
    SENTENCE = "on the free one of the spot “middle blue” and the spot “middle yellow” that is furthest from the ball"

    def compile(self, to: Scope, _entity: int) -> PlaceResolver:
        return compile_free_spot(self, to, self.furthest_free, self.from_, sign=-1.0)

    def describe(self, phrases: Phrases) -> str:
        return describe_free_spot(self, phrases, "furthest from", self.furthest_free, self.from_)
