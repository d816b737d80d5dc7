"""An entity's way into and out of a region."""

from __future__ import annotations

from rcj_challenges.core.play import Pose2
from rcj_challenges.geometry.regions import Cell, Region
from rcj_challenges.tracking.bound_rules import TriggerBinding
from rcj_challenges.tracking.state import RefereeState
from rcj_challenges.tracking.trackers import Missed, PositionTracker


class ZoneTracker(PositionTracker):
    """Follows an entity into and out of a region."""

    def __init__(self, state: RefereeState, entity: int, region: Region, zones: tuple[str, ...]) -> None:
        super().__init__(state, entity)
        self.entering: list[TriggerBinding] = []
        self.leaving: list[TriggerBinding] = []
        self._region = region
        self._zones = zones
        self.entities = (entity, *region.anchors)
        self._inside = False

    def reset(self) -> None:
        """Take the present side for the one it was on before."""
        x, y, _ = self._state.poses[self.entity]
        self._inside = self._region.contains(x, y)

    def moved(self) -> None:
        """Reset; what is put inside has not entered."""
        self.reset()
        # If the region moves with something, that may have been put elsewhere.
        if self._inside and self.entering and self._state.present[self.entity] and len(self.entities) == 1:
            zone = self._zones[0] if len(self._zones) == 1 else f"[{', '.join(self._zones)}]"
            self.missed = self.missed or Missed(self._state.tick, "placed", zone, self.entering)

    def cell(self, x_m: float, y_m: float) -> Cell:
        """Return the region's cell."""
        return self._region.cell(x_m, y_m)

    def advance(self, _before: list[Pose2], substeps: list[list[Pose2]]) -> None:
        """Report each kind of change once a tick, also one that is undone in a later sub-step."""
        entered = left = False
        for poses in substeps:
            self._state.seen = poses
            x, y, _ = poses[self.entity]
            inside = self._region.contains(x, y)
            if inside != self._inside:
                self._inside = inside
                entered, left = entered or inside, left or not inside
        self._state.seen = None
        if entered:
            self._hits.report(self.entering)
        if left:
            self._hits.report(self.leaving)
