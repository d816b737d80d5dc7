"""The value ``count``."""

from collections.abc import Callable
from typing import Annotated

from rcj_challenges.rules.base import Phrases, Scope
from rcj_challenges.rules.facts import Facts
from rcj_challenges.rules.fields import Names, described
from rcj_challenges.rules.refs import ENTITIES
from rcj_challenges.rules.values.number import NumberValue


class CountValue(Facts, NumberValue):
    """How many of a group are on the field or, with facts, of how many of them these are all true."""

    count: Annotated[Names, ENTITIES] = described(..., "a group, others, or a list")

    KEY = "count"
    OWNER = "count"
    EXAMPLE = """
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    # Two points for each blue robot in front of the goal, and one for each yellow robot on the field.
    actions:
      - action: score
        entrant: yellow
        points: {count: blue, in: blue_penalty_area, times: 2, plus: {count: yellow}}
expect:
  one_defender_and_three_robots_give_five_points:
    keyframes: [{at_s: 1, place: {ball: [0, 0.8], B1: [0.2, 0.65], B2: [0, 0]}}]
    lasts_s: 2
    score: {yellow: 5}
"""
    SENTENCE = "the number of blue robots that are in the blue penalty area"

    def now(self, to: Scope) -> Callable[[], int]:
        state, facts = to.state, self.facts(to)
        members, members_now = to.group(self.count)
        index = {member: to.entity(member) for member in members}
        if not facts:
            return lambda: sum(state.present[index[one]] for one in members_now())  # integers
        return lambda: sum(all(fact(index[one]) for fact in facts) for one in members_now())  # integers

    def describe(self, phrases: Phrases) -> str:
        facts, group = self.describe_facts(phrases), phrases.all_of(self.count).text.removeprefix("the ")
        return f"the number of {group} that are {facts}" if facts else f"the number of {group} on the field"
