"""The place ``furthest_free``."""

from typing import Annotated

from pydantic import Field

from rcj_challenges.rules.fields import Names, Point, described
from rcj_challenges.rules.places.free_spots import REFERENCES, FreeSpot
from rcj_challenges.rules.refs import ANCHORS, SPOTS


class FurthestFree(FreeSpot):
    """The furthest free spot, or one chosen at random among the furthest."""

    furthest_free: Annotated[Names, SPOTS] = described(..., "spots, or a group of spots")
    from_: Annotated[Names | Point | None, ANCHORS] = Field(
        None, alias="from", description=f"what to be far from: {REFERENCES}"
    )

    KEY = "furthest_free"
    REFERENCE = "from_"
    SIGN = -1.0
    HOW = "furthest from"
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
