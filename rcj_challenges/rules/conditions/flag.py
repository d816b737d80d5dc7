"""The condition ``flag``."""

from typing import Annotated

from rcj_challenges.rules.base import Binder, Condition, Phrases, Test
from rcj_challenges.rules.fields import Name, Names, described
from rcj_challenges.rules.kept import asked, kept, test_of_kept
from rcj_challenges.rules.phrasing import quoted
from rcj_challenges.rules.quantifier import Quantifier
from rcj_challenges.rules.refs import FLAG, WHOSE_OF


class FlagIs(Condition):
    """Whether a flag is set."""

    flag: Annotated[Name, FLAG] = described(..., "a flag")
    entity: Annotated[Names | None, WHOSE_OF] = described(
        None,
        "for a flag kept per entity: which entity; each: the current member; if omitted and "
        "there is no for_each: any of them; "
        "with `of` also a group or a list",
    )
    of: Quantifier | None = described(
        None, "how many members of a group must satisfy it; without entity: of all members"
    )

    KEY = "flag"
    EXAMPLE = """
flags:
  lights: {}
  doubled: {}
rules:
  switch:
    triggers: [{trigger: touches, entity: robots, other: ball}]
    actions: [{action: set_flag, flag: lights, to: opposite}]
  late:
    triggers: [{trigger: time_reached, at_s: 3}]
    actions: [{action: set_flag, flag: doubled}]
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    conditions: [{flag: lights}, {flag: doubled, negate: true}]
    actions: [{action: score, entrant: yellow}]
expect:
  it_counts_while_the_lights_are_on:
    keyframes: [{at_s: 1, touch: [[Y1, ball]]}, {at_s: 2, place: {ball: [0, 0.8]}}]
    lasts_s: 4
    score: {yellow: 1}
    flags: {lights: true, doubled: true}
"""
    SENTENCE = "the flag “lights” is set"

    def test(self, to: Binder) -> Test:
        state, name = to.state, self.flag
        return test_of_kept(self, to, "flags", name, state.flags[name], lambda whose: state.flag(name, whose))

    def describe(self, phrases: Phrases) -> str:
        subject = asked(phrases, self, "flag", self.flag)
        if subject is not None:
            return f"{subject.does('has', 'have')} the flag {quoted(self.flag)} set"
        return f"{kept(phrases, self, 'flag', self.flag)} is {'not ' if self.negate else ''}set"
