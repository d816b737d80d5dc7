"""The value ``role``."""

from collections.abc import Callable
from typing import Annotated

from rcj_challenges.rules.base import Phrases, Scope, ValueWord
from rcj_challenges.rules.fields import Name, Scalar, described
from rcj_challenges.rules.phrasing import quoted_measure
from rcj_challenges.rules.refs import ROLE


class RoleValue(ValueWord):
    """The name of the one that has a role now; null if none has it."""

    role: Annotated[Name, ROLE] = described(..., "a role")

    KEY = "role"
    EXAMPLE = """
roles: {wanted: {of: neutral_spots, order: listed, cyclic: true}}
rules:
  found:
    triggers: [{trigger: holds, conditions: [{distance: [Y1, wanted], below: 0.1}]}]
    actions: [{action: emit, event: FOUND, payload: {at: {role: wanted}}}, {action: assign, role: wanted}]
expect:
  the_first_is_the_centre:
    keyframes: [{at_s: 1, place: {Y1: [0, 0]}}]
    lasts_s: 2
    events: [{event: FOUND, payload: {at: centre}}]
"""
    SENTENCE = "the name of “wanted”"

    def now(self, to: Scope) -> Callable[[], Scalar | None]:
        draws, name = to.state.draws, self.role
        return lambda: draws[name]

    def describe(self, phrases: Phrases) -> str:
        return f"the name of {quoted_measure(self.role)}"
