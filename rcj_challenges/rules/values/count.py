"""The value ``count``."""

from typing import Annotated

from rcj_challenges.rules.base import Phrases, Reader, Scope
from rcj_challenges.rules.facts import Fact, Facts
from rcj_challenges.rules.fields import Name, Names, described
from rcj_challenges.rules.number import NumberValue
from rcj_challenges.rules.phrasing import listed, quoted
from rcj_challenges.rules.refs import ENTITIES, FLAG


class CountValue(Facts, NumberValue):
    """How many of a group are on the field or, with facts, of how many of them these are all true."""

    count: Annotated[Names, ENTITIES] = described(..., "a group, others, or a list")
    flag: Annotated[Name | None, FLAG] = described(None, "its flag, kept per entity, is set, on the field or off it")

    KEY = "count"
    OWNER = "count"
    REQUIRES = ()
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

    def facts(self, to: Scope) -> tuple[Fact, ...]:
        state, flag = to.state, self.flag
        flagged = () if flag is None else (lambda entity: state.flag(flag, state.names[entity]),)
        return (*super().facts(to), *flagged)

    def describe_facts(self, phrases: Phrases) -> str:
        flagged = [] if self.flag is None else [f"marked by the flag {quoted(self.flag)}"]
        return listed(list(filter(None, [super().describe_facts(phrases), *flagged])), "and")

    def measure(self, to: Scope) -> Reader:
        state, facts = to.state, self.facts(to)
        members, members_now = to.group(self.count)
        index = dict(zip(members, to.entities(members), strict=True))
        if not facts:
            return lambda _firing: sum(state.present[index[one]] for one in members_now())  # integers
        return lambda _firing: sum(all(fact(index[one]) for fact in facts) for one in members_now())  # integers

    def describe(self, phrases: Phrases) -> str:
        facts, group = self.describe_facts(phrases), phrases.all_of(self.count).text.removeprefix("the ")
        return f"the number of {group} that are {facts}" if facts else f"the number of {group} on the field"
