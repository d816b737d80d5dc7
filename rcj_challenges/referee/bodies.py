"""Solid bodies on and around the field; tests whether a thing has room at a pose."""

from __future__ import annotations

from rcj_challenges.core.play import Pose2
from rcj_challenges.scenario.kits import chassis_of
from rcj_challenges.scenario.models.field import FieldModel
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.outlines import (
    TOUCHING_M,
    Outline,
    Part,
    closer_than,
    counter_clockwise,
    disc,
    extent,
    obstacle_outline,
    robot_outline,
)
from rcj_challenges.scenario.positions import start_pose
from rcj_challenges.scenario.roster import Roster

# Walls are solid far beyond their real thickness here, as nothing can stand in or behind them. What is placed outside
# the box around field and goals is refused before any wall is looked at, however far out it is.
_SOLID_M = 10.0


def wall_parts(field: FieldModel) -> tuple[Part, ...]:
    """Return everything solid around the floor: side and end walls, corner walls, goals."""
    x, y, far = field.bounds.width_m / 2, field.bounds.length_m / 2, _SOLID_M
    parts = [_box(x, x + far, -y - far, y + far), _box(-x - far, -x, -y - far, y + far)]
    for end, sign in (("positive_y", 1.0), ("negative_y", -1.0)):
        goals = [goal for goal in field.goals.values() if goal.end == end]
        half = max((goal.width_m / 2 for goal in goals), default=0.0)
        depth = max((goal.depth_m for goal in goals), default=0.0)
        low, high = sorted((sign * y, sign * (y + far)))
        parts += [_box(half, x + far, low, high), _box(-x - far, -half, low, high)]
        back_low, back_high = sorted((sign * (y + depth), sign * (y + far)))
        parts.append(_box(-half, half, back_low, back_high) if goals else _box(-x, x, low, high))
    cut = field.cut_m
    if cut > 0:
        parts += [
            Part(counter_clockwise(((sx * (x - cut), sy * y), (sx * x, sy * (y - cut)), (sx * x, sy * y))))
            for sx in (1, -1)
            for sy in (1, -1)
        ]
    return tuple(parts)


def _box(x_min: float, x_max: float, y_min: float, y_max: float) -> Part:
    return Part(((x_max, y_max), (x_min, y_max), (x_min, y_min), (x_max, y_min)))


class Bodies:
    """The outlines of all entities and of everything fixed.

    Attributes:
        outlines: by entity index.
        fixed: parts of fixed obstacles, which count as bodies; the field's walls and goals do not.
        half_box_m: half widths, along x and y, of the box around field and goals, in m; nothing stands outside.
    """

    def __init__(self, scenario: Scenario, roster: Roster) -> None:
        outlines: list[Outline] = []
        for name in roster.entities:
            if name in scenario.robots:
                outlines.append(robot_outline(chassis_of(scenario, name)))
            elif name in scenario.balls:
                outlines.append(disc(scenario.balls[name].radius_m))
            else:
                outlines.append(obstacle_outline(scenario.obstacles[name]))
        fixed: list[Part] = []
        for name, obstacle in scenario.obstacles.items():
            if name not in roster.entities:
                fixed += obstacle_outline(obstacle).at(start_pose(scenario, name))
        self.outlines = tuple(outlines)
        self.fixed = tuple(fixed)
        # With where they reach from and to, so that few have to be looked at closely.
        self._walls = [(*extent([wall]), wall) for wall in wall_parts(scenario.field)]
        field = scenario.field.bounds
        deepest_m = max((goal.depth_m for goal in field.goals.values()), default=0.0)
        self.half_box_m = (field.width_m / 2, field.length_m / 2 + deepest_m)

    def fits(self, entity: int, pose: Pose2, others: dict[int, Pose2], clearance_m: float) -> bool:
        """Return whether an entity, given by its index, can stand at a pose beside others.

        The clearance is the smallest gap in m to any other body; walls only must not be overlapped.
        """
        if abs(pose[0]) > self.half_box_m[0] or abs(pose[1]) > self.half_box_m[1]:
            return False
        outline = self.outlines[entity]
        parts = outline.at(pose)
        least = clearance_m - TOUCHING_M
        for index, other in others.items():
            near = outline.reach_m + self.outlines[index].reach_m + clearance_m
            if (pose[0] - other[0]) ** 2 + (pose[1] - other[1]) ** 2 > near * near:
                continue
            if any(closer_than(a, b, least) for a in parts for b in self.outlines[index].at(other)):
                return False
        if any(closer_than(part, body, least) for part in parts for body in self.fixed):
            return False
        x, y, reach = pose[0], pose[1], outline.reach_m
        near_walls = [
            wall
            for west, east, south, north, wall in self._walls
            if west - reach < x < east + reach and south - reach < y < north + reach
        ]
        return not any(closer_than(part, wall, -TOUCHING_M) for part in parts for wall in near_walls)
