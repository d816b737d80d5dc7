"""The trigger ``enters``."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import ENTITY_DESCRIPTION, Binder, Phrases, Trigger
from rcj_challenges.rules.effects import Entry
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.refs import ENTITIES, ZONES
from rcj_challenges.tracking.zone_tracker import ZoneTracker


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


def zone_tracker(to: Binder, entity: int, zone: Names) -> ZoneTracker:
    """Return the tracker of an entity into and out of a zone, or of several zones taken as one."""
    zones, region = to.members(zone), to.region(zone)
    tracker = to.track(ZoneTracker, (entity, zones), entity, region, zones)
    to.reset_with_draws(tracker, zones)
    return tracker
