"""The value ``score``."""

from typing import Annotated, Literal

from rcj_challenges.core.amounts import round_score
from rcj_challenges.rules.base import Firing, Number, Phrases, Reader, Scope
from rcj_challenges.rules.fields import Name, described
from rcj_challenges.rules.phrasing import plain
from rcj_challenges.rules.refs import SCORED
from rcj_challenges.rules.values.number import NumberValue


class ScoreValue(NumberValue):
    """The score of an entrant; none if no entrant drives what `each` or `other` is."""

    score: Annotated[Name, SCORED] = described(
        ..., "an entrant, by its seat in this half; each, other: that of the robot"
    )

    since: Literal["half", "phase"] | None = described(
        None, "half: only what it got in this half; phase: only since the phase began, where what came before is kept"
    )

    KEY = "score"
    EXAMPLE = """
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    # The team that is behind gets as many points as it lacks, and one more.
    actions:
      - action: score
        entrant: yellow
        points: {highest: [{score: blue, minus: {score: yellow}, plus: 1}, 1]}
expect:
  four_behind_gives_five:
    given: {score: {blue: 4}}
    keyframes: [{at_s: 1, place: {ball: [0, 0.8]}}]
    lasts_s: 2
    score: {yellow: 5, blue: 4}
"""
    SENTENCE = "the score of blue"

    def as_it_is(self, to: Scope) -> Reader:
        state, name = to.state, self.score
        before = {} if self.since is None else state.began_with[self.since]

        def read(firing: Firing) -> Number | None:
            robot = None if name in state.scores else {"each": firing.rule.each, "other": firing.rule.other}.get(name)
            entrant = name if robot is None else state.entrant_of.get(robot, "")
            score = state.scores.get(entrant)
            return score if score is None or not before else round_score(score - before[entrant])

        return read

    def describe(self, phrases: Phrases) -> str:
        since = {None: "", "half": f" in this {phrases.period}", "phase": " in this phase"}[self.since]
        if phrases.is_entrant(self.score):
            return f"the score of {plain(self.score)}{since}"
        team = "its team" if self.score == "each" else f"the team of {phrases.thing(self.score)}"
        return f"the score of {team}{since}"
