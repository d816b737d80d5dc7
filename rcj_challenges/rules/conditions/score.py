"""What is particular to the condition ``score``."""

from rcj_challenges.rules.base import Phrases
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.values.score import ScoreValue


class ScoreIs(Compared, ScoreValue):
    """The score of an entrant."""

    VALUE = ScoreValue
    EXAMPLE = """
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    # The first goal of a team that is behind counts twice.
    conditions: [{score: yellow, below: {score: blue}}]
    actions: [{action: score, entrant: yellow, points: 2}]
expect:
  behind_it_counts:
    given: {score: {blue: 1}}
    keyframes: [{at_s: 1, place: {ball: [0, 0.8]}}]
    lasts_s: 2
    score: {yellow: 2, blue: 1}
  else_it_does_not:
    keyframes: [{at_s: 1, place: {ball: [0, 0.8]}}]
    lasts_s: 2
    score: {yellow: 0}
"""
    SENTENCE = "the score of yellow is less than the score of blue"

    def describe(self, phrases: Phrases) -> str:
        if self.score == "entrants" and not self.value.is_computed():
            subject = phrases.quantified(self.of or "any", self.score, negate=self.negate)
            return f"{subject.does('has', 'have')} a score of {self.compared(phrases)}"
        other = self.equals
        is_plain = isinstance(other, ScoreValue) and other.since is self.since is None
        if not isinstance(other, ScoreValue) or not is_plain or other.is_computed() or self.value.is_computed():
            return super().describe(phrases)
        scores = f"the scores of {phrases.entrant(self.score)} and {phrases.entrant(other.score)}"
        return f"{scores} {'differ' if self.negate else 'are equal'}"
