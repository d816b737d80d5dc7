"""Solid bodies on and around the field; tests whether a thing has room at a pose."""

from __future__ import annotations

from rcj_challenges.core.play import Pose2
from rcj_challenges.scenario.kits import chassis_of
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.outlines import (
    TOUCHING_M,
    Floor,
    Outline,
    Part,
    closer_than,
    disc,
    obstacle_outline,
    robot_outline,
)
from rcj_challenges.scenario.positions import start_pose
from rcj_challenges.scenario.roster import Roster


class Bodies:
    """The outlines of all entities and of everything fixed.

    Attributes:
        outlines: by entity index.
        fixed: parts of fixed obstacles, which count as bodies; the field's walls and goals do not.
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
        self._floor = Floor(scenario.field)

    def fits(self, entity: int, pose: Pose2, others: dict[int, Pose2], clearance_m: float) -> bool:
        """Return whether an entity, given by its index, can stand at a pose beside others.

        The clearance is the smallest gap in m to any other body; walls only must not be overlapped.
        """
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
        return self._floor.holds(parts)
