"""The value ``role``."""

from typing import Annotated

from rcj_challenges.rules.base import Phrases, Reader, Scope, ValueWord
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.phrasing import quoted_measure
from rcj_challenges.rules.refs import ROLE


class RoleValue(ValueWord):
    """The name of the one that has a role now; null if none has it."""

    role: Annotated[Name, ROLE] = described(..., "a role")

    KEY = "role"
    EXAMPLE = """
roles: {hunter: {of: robots, order: listed, initial: none}}
rules:
  first:
    for_each: robots
    triggers: [{trigger: touches, entity: each, other: ball}]
    conditions: [{role: hunter, equals: none}]
    actions: [{action: assign, role: hunter, to: each}, {action: emit, event: FIRST, payload: {hunter: {role: hunter}}}]
  again:
    priority: 1
    for_each: robots
    triggers: [{trigger: touches, entity: each, other: ball}]
    conditions: [{role: hunter, equals: each}]
    actions: [{action: score, entrant: each}]
expect:
  the_first_to_touch_the_ball_gets_points_for_it:
    keyframes: [{at_s: 1, touch: [[Y2, ball]]}, {at_s: 2, touch: [[B1, ball]]}, {at_s: 3, touch: [[Y2, ball]]}]
    lasts_s: 4
    score: {yellow: 2, blue: 0}
    events: [{event: FIRST, payload: {hunter: Y2}}]
"""

    def read(self, to: Scope) -> Reader:
        draws, name = to.state.draws, self.role
        return lambda _firing: draws[name]

    def describe(self, phrases: Phrases) -> str:
        return f"the name of {quoted_measure(self.role)}"
