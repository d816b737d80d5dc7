"""The trigger ``leaves``."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import ENTITY_DESCRIPTION, Binder, Phrases, Trigger
from rcj_challenges.rules.effects import Passage
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.refs import ENTITIES, ZONES
from rcj_challenges.rules.triggers.enters import zone_tracker


class Leaves(Trigger):
    """Fires when an entity's centre leaves a zone."""

    trigger: Literal["leaves"]
    entity: Annotated[Names, ENTITIES] = described(..., ENTITY_DESCRIPTION)
    zone: Annotated[Names, ZONES] = described(
        ..., "a zone, each, or a draw's name; with a list or group: from any of them to outside all of them"
    )

    REASON = "left {zone}"
    MOMENT = Passage
    EXAMPLE = """
rules:
  out:
    for_each: robots
    triggers: [{trigger: leaves, entity: each, zone: in_play}]
    actions: [{action: emit, event: OUT, payload: {robot_name: {word: robot_name}}}]
expect:
  the_robot_is_named:
    keyframes: [{at_s: 1, place: {B2: [0.7, 0]}}]
    lasts_s: 2
    events: [{event: OUT, at_s: 1, payload: {robot_name: B2}}]
"""

    def bind(self, to: Binder) -> None:
        for entity in to.entities(self.entity):
            zone_tracker(to, entity, self.zone).leaving.append(to.binding(entity))

    def describe(self, phrases: Phrases) -> str:
        # Of several zones: out of all of them.
        return f"{phrases.any_of(self.entity)} leaves {phrases.all_of(self.zone).text}"
