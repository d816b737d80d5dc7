"""The value ``score``."""

from collections.abc import Callable
from typing import Annotated, Literal

from rcj_challenges.core.amounts import round_score
from rcj_challenges.rules.base import Firing, Number, Phrases, Reader, Scope
from rcj_challenges.rules.fields import Name, Names, described
from rcj_challenges.rules.number import NumberValue
from rcj_challenges.rules.phrasing import Clause
from rcj_challenges.rules.refs import SCORED


class ScoreValue(NumberValue):
    """The score of an entrant; none if no entrant drives what `each` or `other` is."""

    OVER = "score"

    score: Annotated[Name, SCORED] = described(
        ...,
        "an entrant, by its seat in this half; each, others, other: the entrant, or that of the robot; in "
        "highest, lowest and sum also entrants",
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
    conditions: [{score: yellow, below: {score: blue}}]
    actions:
      - action: score
        entrant: yellow
        points: {score: blue, minus: {score: yellow}, plus: 1}
expect:
  four_behind_gives_five:
    given: {score: {blue: 4}}
    keyframes: [{at_s: 1, place: {ball: [0, 0.8]}}]
    lasts_s: 2
    score: {yellow: 5, blue: 4}
  else_it_gets_none:
    keyframes: [{at_s: 1, place: {ball: [0, 0.8]}}]
    lasts_s: 2
    score: {yellow: 0}
"""

    def measure(self, to: Scope) -> Reader:
        scores, entrants = to.state.scores, to.entrants(self.score)
        before = {} if self.since is None else to.state.began_with[self.since]

        def read(_firing: Firing) -> Number | None:
            score = scores[entrants[0]] if entrants else None
            return score if score is None or not before else round_score(score - before[entrants[0]])

        return read

    def members(self, to: Scope, names: Names) -> tuple[tuple[str, ...], Callable[[], tuple[str, ...]]]:
        entrants = to.entrants(names)
        return entrants, lambda: entrants

    def describe(self, phrases: Phrases) -> str:
        since = {None: "", "half": f" in this {phrases.period}", "phase": " in this phase"}[self.since]
        return f"the score of {phrases.entrant(self.score)}{since}"

    def clause(self, _phrases: Phrases) -> Clause | None:
        return Clause(self.score, "has", "have", "a score of {}") if self.score == "entrants" else None
