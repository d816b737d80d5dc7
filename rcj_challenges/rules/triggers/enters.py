"""The trigger ``enters``."""

from typing import Annotated, Literal

from rcj_challenges.core.play import Pose2
from rcj_challenges.geometry.regions import Cell, Region
from rcj_challenges.rules.base import ENTITY_DESCRIPTION, Binder, Phrases, Trigger
from rcj_challenges.rules.effects import Entry
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.refs import ENTITIES, ZONES
from rcj_challenges.tracking.bound_rules import TriggerBinding
from rcj_challenges.tracking.state import RefereeState
from rcj_challenges.tracking.trackers import Missed, PositionTracker


class Enters(Trigger):
    """Fires when an entity's centre enters a zone."""

    trigger: Literal["enters"]
    entity: Annotated[Names, ENTITIES] = described(..., ENTITY_DESCRIPTION)
    zone: Annotated[Names, ZONES] = described(
        ..., "a zone, each, or a draw's name; with a list or group: into any of them from outside all of them"
    )

    NOTES = (
        "Zones that are named together count as one: moving from one straight into the other is not entering.",
        "A rule without for_each fires once if several entities enter in one tick; with for_each, once for each.",
    )
    MOMENT = Entry
    EXAMPLE = """
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: [blue_goal, yellow_goal]}]
    actions: [{action: emit, event: GOAL}]
expect:
  it_fires_when_the_centre_is_inside:
    keyframes:
      - {at_s: 1, place: {ball: [0, 0.6]}}
      - {at_s: 2, move: {ball: [0, 0.8]}}
    lasts_s: 3
    events: [{event: GOAL, at_s: 1.73, tolerance_s: 0.05}]
"""

    def bind(self, to: Binder) -> None:
        for entity in to.entities(self.entity):
            zone_tracker(to, entity, self.zone).entering.append(to.binding(entity))

    def describe(self, phrases: Phrases) -> str:
        return f"{phrases.any_of(self.entity)} enters {phrases.any_of(self.zone)}"


def zone_tracker(to: Binder, entity: int, zone: Names) -> "ZoneTracker":
    """Return the tracker of an entity into and out of a zone, or of several zones taken as one."""
    zones, region = to.members(zone), to.region(zone)
    tracker = to.track(ZoneTracker, (entity, zones), entity, region, zones)
    to.reset_with_draws(tracker, zones)
    return tracker


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
