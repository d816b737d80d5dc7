"""The trigger ``event``."""

from typing import Annotated, Literal

from rcj_challenges.rules.base import Binder, Phrases, Trigger
from rcj_challenges.rules.effects import EventSeen
from rcj_challenges.rules.fields import EventName, Names, described
from rcj_challenges.rules.refs import KEEPING, Ref


class OnEvent(Trigger):
    """Fires one tick after an event was emitted."""

    trigger: Literal["event"]
    event: EventName = described(..., "the event")
    entity: Annotated[Names | None, Ref("entity, obstacle, zone or gate", KEEPING, groups=True, each=True)] = described(
        None,
        "only events about this entity: an entity, a fixed obstacle, a zone or gate, a group (any member), or "
        "each; if omitted: all events. An event is about the for_each member of the rule that emitted it, or "
        "else about the entity of that rule's trigger",
    )

    MOMENT = EventSeen
    EXAMPLE = """
# `entity: each` (or a name) limits it to events about that entity: {trigger: event, event: FOUL, entity: each}.
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions: [{action: emit, event: GOAL}]
  cheer:
    triggers: [{trigger: event, event: GOAL}]
    actions: [{action: emit, event: CHEER}]
expect:
  one_tick_later:
    keyframes: [{at_s: 0.96, place: {ball: [0, 0.8]}}]
    lasts_s: 2
    events: [{event: GOAL, at_s: 0.96, tolerance_s: 0.01}, {event: CHEER, at_s: 0.992, tolerance_s: 0.01}]
"""

    def bind(self, to: Binder) -> None:
        """Bind a rule to an event, or to the event about each of those that are named."""
        events = to.clock_events.events
        for name in (None,) if self.entity is None else to.members(self.entity):
            events.setdefault((self.event, name), []).append(to.binding(name))

    def describe(self, phrases: Phrases) -> str:
        return f"{self.event} was announced" + (f" of {phrases.any_of(self.entity)}" if self.entity else "")
