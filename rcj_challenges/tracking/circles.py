"""Circles that sit at a spot or move with an entity."""

from __future__ import annotations

from collections.abc import Callable
from math import inf

from rcj_challenges.core.play import Pose2
from rcj_challenges.geometry.polygons import Point
from rcj_challenges.geometry.regions import NOWHERE, Cell, Circle
from rcj_challenges.tracking.gates import seen_from


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
