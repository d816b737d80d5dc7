"""The value ``entity``: facts about what is on the field."""

from collections.abc import Callable
from typing import Annotated

from rcj_challenges.rules.base import Phrases, Scope
from rcj_challenges.rules.facts import Facts
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.phrasing import number
from rcj_challenges.rules.refs import ENTITY
from rcj_challenges.rules.values.number import NumberValue


class FactValue(Facts, NumberValue):
    """Whether all the facts that are given are true of an entity: true or false; as a number 1 or 0."""

    entity: Annotated[Name, ENTITY] = described(
        ..., "an entity, or each; in highest, lowest and sum also a group or others"
    )

    KEY = "entity"
    OWNER = "entity"
    OVER = "entity"
    REQUIRES = Facts.REQUIRES
    EXAMPLE = """
rules:
  penalty:
    triggers: [{trigger: touches, entity: Y1, other: walls}]
    actions: [{action: hold, entity: Y1, for_s: 3}]
broadcast:
  fields: {Y1_is_held: {entity: Y1, held: true}}
expect:
  programs_learn_that_it_is_held:
    keyframes: [{at_s: 1, touch: [[Y1, walls]]}]
    lasts_s: 2
    told: {robots: {Y1_is_held: true}}
"""
    SENTENCE = "whether Y1 is held"

    def now(self, to: Scope) -> Callable[[], bool]:
        entity, facts = to.entity(self.entity), self.facts(to)
        return lambda: all(fact(entity) for fact in facts)

    def describe(self, phrases: Phrases) -> str:
        return f"whether {phrases.thing(self.entity)} is {self.describe_facts(phrases)}"

    def describe_number(self, phrases: Phrases) -> str:
        return self.describe_times(phrases, 1)

    def describe_times(self, phrases: Phrases, factor: float) -> str:
        return f"{number(factor)} if {phrases.thing(self.entity)} is {self.describe_facts(phrases)}"
