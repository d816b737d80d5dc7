"""The field while things are placed."""

from __future__ import annotations

from rcj_challenges.core.play import Pose2
from rcj_challenges.referee.bodies import Bodies
from rcj_challenges.referee.state import State
from rcj_challenges.tracking.places import Point


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
