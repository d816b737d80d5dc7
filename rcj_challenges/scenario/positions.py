"""Where things are: the floor inside the walls, centres of zones and obstacles, poses at the start of a half."""

from __future__ import annotations

from collections.abc import Sequence
from math import atan2

from rcj_challenges.core.play import Pose2
from rcj_challenges.geometry.polygons import Point, side, turned
from rcj_challenges.scenario.models.field import Box, Cylinder, FieldModel, Obstacle, Wall
from rcj_challenges.scenario.models.places import CircleZone, RectZone, Zone
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.outlines import counter_clockwise
from rcj_challenges.scenario.shapes import floor_of, goal_floor

Corners = tuple[Point, ...]


def floor_parts(field: FieldModel) -> list[Corners]:
    """Return the convex parts of the floor, inside the walls if any: the field, then its goals, counter-clockwise."""
    outlines = (floor_of(field.bounds), *(goal_floor(goal, field) for goal in field.goals.values()))
    return [counter_clockwise(tuple(outline)) for outline in outlines]


def on_floor(point: Point, parts: Sequence[Corners]) -> bool:
    """Return whether a point is on the floor."""
    return any(all(side(a, b, point) >= 0 for a, b in zip(p, (*p[1:], p[0]), strict=True)) for p in parts)


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


def middle_of(obstacle: Obstacle) -> tuple[float, float, float]:
    """Return the pose of a fixed obstacle, [x, y, yaw] in m and rad: a wall from its middle along its line."""
    match obstacle:
        case Wall():
            (ax, ay), (bx, by) = obstacle.from_m, obstacle.to_m
            return (ax + bx) / 2, (ay + by) / 2, atan2(by - ay, bx - ax)
        case Box():
            return *obstacle.centre_m, obstacle.yaw_rad
        case Cylinder():
            return *obstacle.centre_m, 0.0


def at_start(zone: Zone, scenario: Scenario) -> Zone:
    """Return a zone where it is at the start: a circle with an anchor is beside that."""
    if not isinstance(zone, CircleZone) or zone.anchor is None:
        return zone
    spot = scenario.spots.get(zone.anchor)
    pose = start_pose(scenario, zone.anchor) if spot is None else (spot.x_m, spot.y_m, 0.0)
    return zone.model_copy(update={"centre_m": turned([zone.middle_m], pose)[0]})


def start_pose(scenario: Scenario, name: str) -> Pose2:
    """Return the start of a robot, ball or obstacle, without noise: x and y in m, yaw in rad.

    A wall has no place of its own: its ends say where it stands.
    """
    if name in scenario.robots:
        start = scenario.robots[name].start
        return start.x_m, start.y_m, start.yaw_rad
    if name in scenario.balls:
        return (*scenario.balls[name].start_m, 0.0)
    obstacle = scenario.obstacles[name]
    return (0.0, 0.0, 0.0) if isinstance(obstacle, Wall) else middle_of(obstacle)


def start_noise_m(scenario: Scenario, name: str) -> tuple[float, float]:
    """Return the half widths, on x and y in m, of the noise around the place where something starts."""
    return scenario.robots[name].start.noise_m if name in scenario.robots else (0.0, 0.0)
