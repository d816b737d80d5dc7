"""Gates and circles that move with something."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, inf, sin

from rcj_challenges.core.play import Pose2
from rcj_challenges.geometry.polygons import Point, distance_to_segment_m
from rcj_challenges.geometry.regions import NOWHERE, Cell, Circle, box_around, crossing
from rcj_challenges.tracking.state import RefereeState


class GateLine:
    """A gate on the field: fixed, or moving and turning with an entity.

    Args:
        from_m, to_m: its ends in m; relative to the anchor if there is one.
        anchor: the index of the entity with which it moves; None: fixed.
    """

    def __init__(
        self, from_m: tuple[float, float], to_m: tuple[float, float], anchor: int | None, state: RefereeState
    ) -> None:
        self.anchor = anchor
        self._from, self._to = from_m, to_m
        self._state = state

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return a cell that the gate does not reach into; a moving gate leaves none."""
        if self.anchor is not None:
            return NOWHERE
        return box_around(x_m, y_m, distance_to_segment_m(x_m, y_m, *self._from, *self._to))

    def distance_m(self, x_m: float, y_m: float) -> float | None:
        """Return the distance of a point in m; None while what it moves with is off the field."""
        if self.anchor is None:
            return distance_to_segment_m(x_m, y_m, *self._from, *self._to)
        if not self._state.present[self.anchor]:
            return None
        seen = seen_from(self._state.poses[self.anchor], (x_m, y_m, 0.0))
        return distance_to_segment_m(*seen, *self._from, *self._to)

    def crossed(self, entity: int, was: list[Pose2], now: list[Pose2]) -> int:
        """Return 1 if the entity crossed it forward in this sub-step, -1 backward, 0 if it did not."""
        if self.anchor is None:
            return crossing(was[entity][:2], now[entity][:2], self._from, self._to)
        if not self._state.present[self.anchor]:
            return 0
        start = seen_from(was[self.anchor], was[entity])
        end = seen_from(now[self.anchor], now[entity])
        return crossing(start, end, self._from, self._to)


def seen_from(anchor: Pose2, pose: Pose2) -> tuple[float, float]:
    """Return x and y in m of a pose in the frame of an anchor that moves and turns."""
    dx, dy = pose[0] - anchor[0], pose[1] - anchor[1]
    c, s = cos(anchor[2]), sin(anchor[2])
    return (c * dx + s * dy, c * dy - s * dx)


class AnchoredCircle(Circle):
    """A circle in the frame of something; while that is off the field nothing is in it.

    Args:
        locate: returns the pose of the anchor at the sub-step that is looked at; None while it is off the field.
        anchors: the index of the entity that the anchor is, if it is one.
    """

    def __init__(
        self, centre_m: Point, radius_m: float, locate: Callable[[], Pose2 | None], anchors: tuple[int, ...]
    ) -> None:
        super().__init__(centre_m, radius_m)
        self._locate = locate
        self.anchors = anchors

    def contains(self, x_m: float, y_m: float) -> bool:
        """Return whether the point is nearer to the centre than the radius; False while the anchor is off the field."""
        pose = self._locate()
        return pose is not None and super().contains(*seen_from(pose, (x_m, y_m, 0.0)))

    def cell(self, _x_m: float, _y_m: float) -> Cell:
        """Return no cell: the circle may move."""
        return NOWHERE

    def outline_m(self, x_m: float, y_m: float) -> float:
        """Return the distance to the circle's line; infinite while the anchor is off the field."""
        pose = self._locate()
        return inf if pose is None else super().outline_m(*seen_from(pose, (x_m, y_m, 0.0)))

    def away_m(self, x_m: float, y_m: float) -> float | None:
        """Return the distance of a point in m; None while the anchor is off the field."""
        return None if self._locate() is None else super().away_m(x_m, y_m)
