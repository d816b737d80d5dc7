"""The value ``held``."""

from collections.abc import Callable
from functools import partial
from typing import Annotated

from rcj_challenges.rules.base import Phrases, Scope, ValueWord
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.refs import ROBOT


class HeldValue(ValueWord):
    """Whether a robot is held, by a rule or because the phase holds all robots: true or false."""

    held: Annotated[Name, ROBOT] = described(..., "a robot, or each")

    KEY = "held"
    EXAMPLE = """
rules:
  penalty:
    triggers: [{trigger: touches, entity: Y1, other: walls}]
    actions: [{action: hold, entity: Y1, for_s: 3}]
broadcast:
  fields: {Y1_is_held: {held: Y1}}
expect:
  programs_learn_that_it_is_held:
    keyframes: [{at_s: 1, touch: [[Y1, walls]]}]
    lasts_s: 2
    told: {robots: {Y1_is_held: true}}
"""
    SENTENCE = "whether Y1 is held"

    def now(self, to: Scope) -> Callable[[], bool]:
        return partial(to.state.held.holds, to.entity(self.held))

    def describe(self, phrases: Phrases) -> str:
        return f"whether {phrases.thing(self.held)} is held"
