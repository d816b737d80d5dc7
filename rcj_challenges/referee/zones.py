"""The region of a zone of the scenario."""

from __future__ import annotations

from math import inf

from rcj_challenges.geometry.regions import Circle, HalfPlane, Outlined, Outside, Polygon, Rect
from rcj_challenges.rules.fields import Strict
from rcj_challenges.scenario.models.places import CircleZone, HalfPlaneZone, PolygonZone, RectZone


def region_of(zone: Strict) -> Outlined:
    """Return the region of a zone of the scenario.

    Raises:
        TypeError: the zone is of no known shape.
    """
    region: Outlined
    match zone:
        case RectZone():
            region = Rect(
                -inf if zone.x_min_m is None else zone.x_min_m,
                inf if zone.x_max_m is None else zone.x_max_m,
                -inf if zone.y_min_m is None else zone.y_min_m,
                inf if zone.y_max_m is None else zone.y_max_m,
            )
        case CircleZone():
            region = Circle(zone.middle_m, zone.radius_m)
        case PolygonZone():
            region = Polygon(zone.points_m)
        case HalfPlaneZone():
            region = HalfPlane(zone.through_m, zone.normal)
        case _:
            message = f"not a zone: {type(zone).__name__}"
            raise TypeError(message)
    return Outside(region) if zone.inverted else region
