"""Solid bodies on and around the field, and the field while things are placed: whether a thing has room at a pose."""

from __future__ import annotations

from rcj_challenges.core.play import Pose2
from rcj_challenges.referee.state import State
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.outlines import TOUCHING_M, Floor, closer_than, outline_of
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.scenario.shapes import start_pose
from rcj_challenges.tracking.places import Point


class Bodies:
    """The outlines of all entities and of everything fixed.

    Attributes:
        outlines: by entity index.
        fixed: parts of fixed obstacles, which count as bodies; the field's walls and goals do not.
        floor: the field between its walls, with its goals.
    """

    def __init__(self, scenario: Scenario, roster: Roster) -> None:
        self.outlines = tuple(outline_of(scenario, name) for name in roster.entities)
        fixed = [name for name in scenario.obstacles if name not in roster.entities]
        self.fixed = tuple(part for name in fixed for part in outline_of(scenario, name).at(start_pose(scenario, name)))
        self.floor = Floor(scenario.field)

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
        return self.floor.holds(parts)


class PlacementBoard:
    """The field while things are placed.

    Attributes:
        poses: by entity, where it is: placed already, or not moved, or (lifted) where it was.
        on_field: those that stand on the field now, by index: not moved, or placed already.
    """

    def __init__(self, state: State, bodies: Bodies, lifted: set[int]) -> None:
        self._state = state
        self._bodies = bodies
        self.poses = list(state.poses)
        self.on_field = {
            index: pose for index, pose in enumerate(state.poses) if state.present[index] and index not in lifted
        }
        self._judged = state.roster.robots + state.roster.balls

    def place(self, entity: int, pose: Pose2) -> None:
        """Place an entity."""
        self.poses[entity] = pose
        self.on_field[entity] = pose

    def free(self, spot: Point, clearance_m: float, entity: int | None) -> bool:
        """Return whether no robot's or ball's centre is nearer to a spot than a strict limit in m; see `Board`."""
        centres = [pose for index, pose in self.on_field.items() if index < self._judged and index != entity]
        if entity is not None and entity < self._judged and self._state.present[entity]:
            centres.append(self._state.poses[entity])
        limit = clearance_m * clearance_m
        return all((x - spot[0]) ** 2 + (y - spot[1]) ** 2 >= limit for x, y, _ in centres)

    def fits(self, entity: int, pose: Pose2, clearance_m: float) -> bool:
        """Return whether an entity can stand at a pose without overlapping anything."""
        others = {index: other for index, other in self.on_field.items() if index != entity}
        return self._bodies.fits(entity, pose, others, clearance_m)
