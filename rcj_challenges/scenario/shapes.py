"""Zones, floors and gates as polygons and lines, points as text, and where things are at the start of a half."""

from __future__ import annotations

import math

from rcj_challenges.core.play import Pose2
from rcj_challenges.geometry.polygons import Point, turned
from rcj_challenges.scenario.models.field import Box as BoxObstacle
from rcj_challenges.scenario.models.field import Cylinder, FieldModel, Goal, Wall
from rcj_challenges.scenario.models.places import CircleZone, PolygonZone, RectZone, Zone
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster

Box = tuple[float, float, float, float]
"""Left, bottom, right and top, in m."""

FORWARD_M = 0.05
SPOT_M = 0.012
"""Radius of a spot that is drawn on the field."""
_FAR_M = 1e4
"""Where an open side ends: beyond all that is drawn."""
_CIRCLE_CORNERS = 72


def zone_outline(zone: Zone, bounds: Box) -> list[Point]:
    """Return a zone's outline in m without regard to ``inverted``, clipped at bounds; empty if it is outside."""
    return clipped(_whole_outline(zone), bounds)


def clipped(outline: list[Point], bounds: Box) -> list[Point]:
    """Return the part of a polygon or of a line that is within bounds, its ends included; empty if there is none."""
    left, bottom, right, top = bounds
    for through, normal in (((left, 0), (1, 0)), ((right, 0), (-1, 0)), ((0, bottom), (0, 1)), ((0, top), (0, -1))):
        outline = _beyond(outline, through, normal)
    return outline


def visible_outline(zone: Zone, field: FieldModel, paper: Box) -> list[Point]:
    """Return the part of a zone's outline that is drawn, without regard to ``inverted``; empty if there is none.

    A zone with an open side ends at the edges of the field, because it would cover the goals and all that is around.
    If it begins behind the field, it ends where the goals do.
    """
    if any(abs(part) >= _FAR_M for point in _whole_outline(zone) for part in point):
        w, h = field.reach_m
        return floor_outline(zone, field) or zone_outline(zone, (-w, -h, w, h)) or zone_outline(zone, paper)
    return zone_outline(zone, paper)


def floor_of(field: FieldModel) -> list[Point]:
    """Return the outline of the field inside its walls or edges, without the goals."""
    w, h, cut = field.width_m / 2, field.length_m / 2, field.cut_m
    return [(w - cut, h), (w, h - cut), (w, -h + cut), (w - cut, -h),
            (-w + cut, -h), (-w, -h + cut), (-w, h - cut), (-w + cut, h)]  # fmt: skip


def goal_floor(goal: Goal, field: FieldModel) -> list[Point]:
    """Return the corners of the floor inside a goal, the two on the goal line first."""
    sign = 1 if goal.end == "positive_y" else -1
    near, half = sign * field.length_m / 2, goal.width_m / 2
    far = near + sign * goal.depth_m
    return [(-half, near), (half, near), (half, far), (-half, far)]


def floor_outline(zone: Zone, field: FieldModel) -> list[Point]:
    """Return the outline of the part of a zone that lies on the field; empty if none of it does."""
    w, h = field.width_m / 2, field.length_m / 2
    outline = zone_outline(zone, (-w, -h, w, h))
    for x, y in ((1, 1), (1, -1), (-1, 1), (-1, -1)) if field.cut_m else ():
        outline = _beyond(outline, (x * (w - field.cut_m), y * h), (-x, -y))
    return outline


def _whole_outline(zone: Zone) -> list[Point]:
    match zone:
        case RectZone():
            sides = (zone.x_min_m, -_FAR_M), (zone.y_min_m, -_FAR_M), (zone.x_max_m, _FAR_M), (zone.y_max_m, _FAR_M)
            return corners_of(*(far_m if side_m is None else side_m for side_m, far_m in sides))
        case CircleZone(middle_m=(x, y), radius_m=radius_m):
            turns = (math.tau * k / _CIRCLE_CORNERS for k in range(_CIRCLE_CORNERS))
            return [(x + radius_m * math.cos(turn), y + radius_m * math.sin(turn)) for turn in turns]
        case PolygonZone():
            return list(zone.points_m)
    everything = corners_of(-_FAR_M, -_FAR_M, _FAR_M, _FAR_M)
    return _beyond(everything, zone.through_m, zone.normal)


def _beyond(corners: list[Point], through: Point, normal: Point) -> list[Point]:
    """Return the part of a polygon on the normal's side of a line."""
    depths = [(x - through[0]) * normal[0] + (y - through[1]) * normal[1] for x, y in corners]
    outline: list[Point] = []
    for k, (x, y) in enumerate(corners):
        after = (k + 1) % len(corners)
        if depths[k] >= 0:
            outline.append((x, y))
        if (depths[k] < 0) != (depths[after] < 0):
            share = depths[k] / (depths[k] - depths[after])
            outline.append((x + share * (corners[after][0] - x), y + share * (corners[after][1] - y)))
    return outline


def middle(outline: list[Point]) -> Point:
    """Return the middle of the box around an outline."""
    xs, ys = [x for x, _ in outline], [y for _, y in outline]
    return (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2


def corners_of(left: float, bottom: float, right: float, top: float) -> list[Point]:
    """Return the corners of a box, clockwise."""
    return [(left, top), (right, top), (right, bottom), (left, bottom)]


def forward_mark(start: Point, end: Point, length_m: float = FORWARD_M) -> tuple[Point, Point]:
    """Return both ends of a gate's forward mark: when driving forward, the first post is on the left."""
    x, y = (start[0] + end[0]) / 2, (start[1] + end[1]) / 2
    share = length_m / (math.dist(start, end) or 1.0)
    return (x, y), (x - share * (end[1] - start[1]), y + share * (end[0] - start[0]))


def zone_words(zone: Zone) -> str:
    """Return a zone's numbers in words: ``-0.2 < x < 0.2, y > 0.59``."""
    return f"all but {_shape_words(zone)}" if zone.inverted else _shape_words(zone)


def point_words(point: Point) -> str:
    """Return ``(x, y)`` in m."""
    return f"({point[0] + 0.0:g}, {point[1] + 0.0:g})"  # adding 0 makes no -0


def _shape_words(zone: Zone) -> str:
    match zone:
        case RectZone():
            sides = (_range_words("x", zone.x_min_m, zone.x_max_m), _range_words("y", zone.y_min_m, zone.y_max_m))
            return ", ".join(filter(None, sides)) or "everywhere"
        case CircleZone():
            beside = f"{point_words(zone.middle_m)} from " if any(zone.middle_m) or zone.anchor is None else ""
            of = f"{beside}{zone.anchor}" if zone.anchor else point_words(zone.middle_m)
            return f"within {zone.radius_m:g} of {of}"
        case PolygonZone():
            return "polygon " + " ".join(map(point_words, zone.points_m))
    return f"beyond {point_words(zone.through_m)} towards {point_words(zone.normal)}"


def _range_words(axis: str, low: float | None, high: float | None) -> str:
    if low is None:
        return "" if high is None else f"{axis} < {high:g}"
    return f"{axis} > {low:g}" if high is None else f"{low:g} < {axis} < {high:g}"


# --- where things are -------------------------------------------------------------------------------------------------


def centre_of(zone: Zone) -> tuple[float, float] | None:
    """Return the centre of a zone; None of one that has none, or several points with equal right to the name."""
    if zone.inverted:
        return None
    if isinstance(zone, CircleZone):
        return zone.centre_m if zone.anchor is None else None
    match zone:
        case RectZone(x_min_m=float(x_min), x_max_m=float(x_max), y_min_m=float(y_min), y_max_m=float(y_max)):
            return (x_min + x_max) / 2, (y_min + y_max) / 2
    return None


def at_start(zone: Zone, scenario: Scenario) -> Zone:
    """Return a zone where it is at the start: a circle with an anchor is beside that, or the first that it may be."""
    if not isinstance(zone, CircleZone) or zone.anchor is None:
        return zone
    anchor = Roster.of(scenario).may_be(zone.anchor)[0]
    spot = scenario.spots.get(anchor)
    pose = start_pose(scenario, anchor) if spot is None else (spot.x_m, spot.y_m, 0.0)
    return zone.model_copy(update={"centre_m": turned([zone.middle_m], pose)[0]})


def start_pose(scenario: Scenario, name: str) -> Pose2:
    """Return the start of a robot, ball or obstacle, without noise: x and y in m, yaw in rad; of a wall its middle."""
    if name in scenario.robots:
        start = scenario.robots[name].start
        return start.x_m, start.y_m, start.yaw_rad
    if name in scenario.balls:
        return (*scenario.balls[name].start_m, 0.0)
    match scenario.obstacles[name]:
        case Wall(from_m=(ax, ay), to_m=(bx, by)):
            return (ax + bx) / 2, (ay + by) / 2, math.atan2(by - ay, bx - ax)
        case BoxObstacle(centre_m=(x, y), yaw_rad=yaw_rad):
            return x, y, yaw_rad
        case Cylinder(centre_m=(x, y)):
            return x, y, 0.0


def start_noise_m(scenario: Scenario, name: str) -> tuple[float, float]:
    """Return the half widths, on x and y in m, of the noise around the place where something starts."""
    return scenario.robots[name].start.noise_m if name in scenario.robots else (0.0, 0.0)
