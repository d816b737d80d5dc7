"""The condition ``entity``: facts about what is on the field."""

from typing import Annotated

from rcj_challenges.rules.base import Binder, Condition, Phrases, Test
from rcj_challenges.rules.facts import Facts
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.quantifier import Quantifier, quantified
from rcj_challenges.rules.refs import ENTITIES


class FactIs(Condition, Facts):
    """Where an entity is, what it touches, whether it is held, and what it looks at; all that is given must be true."""

    entity: Annotated[Names, ENTITIES] = described(..., "an entity, each, or a group with `of`")
    of: Quantifier = described("any", "of how many members of a group it must be true")

    KEY = "entity"
    OWNER = "entity"
    ASKS_WHERE = True
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
expect:
  two_of_three_are_a_crowd:
    keyframes: [{at_s: 1, place: {Y1: [-0.2, 0.65], Y2: [0.2, 0.65]}}]
    lasts_s: 3
    events: [{event: CROWD}]
  a_goal_counts_if_y1_watches_it:
    keyframes:
      - {at_s: 1, place: {Y1: [0, 0.2, 1.57], ball: [0, 0.8]}}
      - {at_s: 2, place: {Y1: [0, 0.2, 0], ball: [0, 0]}}
      - {at_s: 3, place: {ball: [0, 0.8]}}
    lasts_s: 4
    score: {yellow: 1}
"""
    SENTENCE = "at least 2 of the yellow robots are in the blue penalty area"

    def test(self, to: Binder) -> Test:
        of, facts, state = self.of, self.facts(to), to.state
        entities = tuple(one for one in to.entities(self.entity) if one not in self._looked_at(to))
        on_field = state.present if self.held is None else (True,) * len(state.present)
        if len(facts) > 1 or self.in_ is None:
            return lambda: quantified(of, (all(fact(e) for fact in facts) for e in entities if on_field[e]))
        region = to.region(self.in_)

        def test() -> bool:  # without a call for each: most conditions about places are these
            poses = state.poses
            return quantified(of, (region.contains(poses[e][0], poses[e][1]) for e in entities if on_field[e]))

        return test

    def _looked_at(self, to: Binder) -> tuple[int, ...]:
        """Return what is looked at, which does not look at itself; nothing if a draw decides."""
        if isinstance(self.looks, int | float | None) or self.looks in to.drawn:
            return ()
        return tuple(target.entity for target in to.targets(self.looks) if target.entity is not None)

    def watched(self, to: Binder) -> tuple[int, ...]:
        if self.about() is None:
            return ()
        looked_at = () if isinstance(self.looks, int | float | None) else to.targets(self.looks)
        others = (target.entity for target in looked_at if target.entity is not None)
        return tuple(dict.fromkeys((*to.entities(self.entity), *others)))

    def about(self) -> Names | None:
        """Return the entities whose place it reads."""
        return None if self.in_ is self.touching is self.looks is None else self.entity

    def describe(self, phrases: Phrases) -> str:
        subject = phrases.quantified(self.of, self.entity, negate=self.negate)
        return f"{subject.does('is', 'are')} {self.describe_facts(phrases)}"
