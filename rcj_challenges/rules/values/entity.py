"""The value ``entity``: facts about what is on the field."""

from collections.abc import Callable
from typing import Annotated

from rcj_challenges.rules.base import Binder, Phrases, Reader, Scope
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.facts import Facts
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.number import NumberValue
from rcj_challenges.rules.phrasing import number
from rcj_challenges.rules.refs import ENTITY


class FactValue(Facts, NumberValue):
    """Whether all the facts that are given are true of an entity: true or false; as a number 1 or 0."""

    entity: Annotated[Names, ENTITY] = described(
        ..., "an entity, or each; in a condition, with `of`, and in highest, lowest and sum also a group or others"
    )

    KEY = "entity"
    OWNER = "entity"
    OVER = "entity"
    IS_FACT = True
    EXAMPLE = """
rules:
  crowd:
    triggers: [{trigger: time_reached, at_s: 2}]
    conditions: [{entity: yellow, in: blue_penalty_area, of: {at_least: 2}}]
    actions: [{action: emit, event: CROWD}]
  watched_goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    # A direction may stand there too: looks: 1.57.
    conditions: [{entity: Y1, looks: ball, within_rad: 0.3}, {entity: Y1, held: true, negate: true}]
    actions: [{action: score, entrant: yellow}]
broadcast:
  fields: {Y1_is_held: {entity: Y1, held: true}}
expect:
  two_of_three_are_a_crowd:
    keyframes: [{at_s: 1, place: {Y1: [-0.2, 0.65], Y2: [0.2, 0.65]}}]
    lasts_s: 3
    events: [{event: CROWD}]
    told: {robots: {Y1_is_held: false}}
  a_goal_counts_if_y1_watches_it:
    keyframes:
      - {at_s: 1, place: {Y1: [0, 0.2, 1.57], ball: [0, 0.8]}}
      - {at_s: 2, place: {Y1: [0, 0.2, 0], ball: [0, 0]}}
      - {at_s: 3, place: {ball: [0, 0.8]}}
    lasts_s: 4
    score: {yellow: 1}
"""

    def measure(self, to: Scope) -> Reader:
        (entity,), facts = to.entities(self.entity), self.facts(to)
        return lambda _firing: all(fact(entity) for fact in facts)

    def fact(self, to: Binder) -> Callable[[], bool | None]:
        """Return the test; None of what is passed over: it is off the field, or what is looked at."""
        (entity,), (first, *more), present = to.entities(self.entity), self.facts(to), to.state.present
        if self.looks not in to.drawn and entity in self._seen(to):
            return lambda: None
        is_off_counted = self.held is not None

        def holds() -> bool | None:
            if not (is_off_counted or present[entity]):
                return None
            return first(entity) and all(fact(entity) for fact in more)

        return holds if more else lambda: first(entity) if is_off_counted or present[entity] else None

    def places(self, to: Scope) -> tuple[int, ...]:
        if self.about() is None:
            return ()
        return tuple(dict.fromkeys((*to.entities(self.entity), *self._seen(to))))

    def _seen(self, to: Scope) -> tuple[int, ...]:
        """Return the entities that are looked at."""
        at = () if isinstance(self.looks, int | float | None) else to.targets(self.looks)
        return tuple(target.entity for target in at if target.entity is not None)

    def about(self) -> Names | None:
        return None if self.in_ is self.touching is self.looks is None else self.entity

    def describe_compared(self, phrases: Phrases, by: Compared) -> str:
        if by.limits():
            return ""
        subject = phrases.quantified(by.of or "any", self.entity, negate=by.negate)
        return f"{subject.does('is', 'are')} {self.describe_facts(phrases)}"

    def describe(self, phrases: Phrases) -> str:
        return f"whether {phrases.any_of(self.entity)} is {self.describe_facts(phrases)}"

    def describe_number(self, phrases: Phrases) -> str:
        return self.describe_times(phrases, 1)

    def describe_times(self, phrases: Phrases, factor: float) -> str:
        return f"{number(factor)} if {phrases.any_of(self.entity)} is {self.describe_facts(phrases)}"
