"""The value ``last_touch``."""

from typing import Annotated

from rcj_challenges.rules.base import Firing, Phrases, Reader, Scope, ValueWord
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.phrasing import LAST_TOUCH_NOTE
from rcj_challenges.rules.refs import THING


class LastTouchValue(ValueWord):
    """The name of the last robot to touch a thing since that thing was placed; null if none has touched it."""

    last_touch: Annotated[Name, THING] = described(..., "what was touched: an entity, a fixed obstacle, or each")

    KEY = "last_touch"
    NOTES = (LAST_TOUCH_NOTE,)
    EXAMPLE = """
rules:
  own_goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    conditions: [{last_touch: ball, equals: blue}]
    actions: [{action: emit, event: OWN_GOAL, payload: {by: {last_touch: ball}}}]
expect:
  the_last_one_counts:
    keyframes:
      - {at_s: 1, touch: [[Y1, ball]]}
      - {at_s: 2, touch: [[B1, ball]]}
      - {at_s: 3, place: {ball: [0, 0.8]}}
    lasts_s: 4
    events: [{event: OWN_GOAL, payload: {by: B1}}]
"""

    def read(self, to: Scope) -> Reader:
        last = to.state.contacts.follow_last(to.entities(self.last_touch)[0])

        def name(_firing: Firing) -> str | None:
            robot = last()
            return None if robot is None else to.state.names[robot]

        return name

    def describe(self, phrases: Phrases) -> str:
        return f"the name of the last to touch {phrases.thing(self.last_touch)}"
