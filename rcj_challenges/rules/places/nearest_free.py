"""The place ``nearest_free``."""

from typing import Annotated

from rcj_challenges.rules.fields import Names, Point, described
from rcj_challenges.rules.places.free_spots import REFERENCES, FreeSpot
from rcj_challenges.rules.refs import ANCHORS, SPOTS


class NearestFree(FreeSpot):
    """The nearest free spot, or one chosen at random among the nearest."""

    nearest_free: Annotated[Names, SPOTS] = described(..., "spots, or a group of spots")
    to: Annotated[Names | Point | None, ANCHORS] = described(None, f"what to be near: {REFERENCES}")

    KEY = "nearest_free"
    REFERENCE = "to"
    SIGN = 1.0
    HOW = "nearest to"
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
