"""What is particular to the condition ``word``."""

from rcj_challenges.rules.base import Phrases
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.values.word import NumberWord


class WordIs(Compared, NumberWord):
    """A number of the match, such as the half that is being played, or the time."""

    VALUE = NumberWord
    EXAMPLE = """
match: {halves: 2, half_s: 60}
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions: [{action: score, entrant: yellow}]
  late_goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    # From the second half on, a goal gives one point more.
    conditions: [{word: halftime, at_least: 2}]
    actions: [{action: score, entrant: yellow}]
expect:
  in_the_first_half_a_goal_is_one_point:
    keyframes: [{at_s: 1, place: {ball: [0, 0.8]}}]
    lasts_s: 2
    score: {yellow: 1}
  in_the_second_half_it_is_two:
    half: 2
    keyframes: [{at_s: 1, place: {ball: [0, 0.8]}}]
    lasts_s: 2
    score: {yellow: 2}
"""
    SENTENCE = "it is half 2 or a later one"

    def is_always(self) -> bool:
        """Return whether it holds at any time: in some half, as rules say it that count time."""
        return self._is_plain_half() and self.at_least == 1 and len(self.limits()) == 1 and not self.negate

    def _is_plain_half(self) -> bool:
        limits = [limit for _, limit in self.limits()]
        is_half = self.word == "halftime" and not self.value.is_computed()
        return is_half and all(isinstance(limit, int) for limit in limits) and self.above is None and self.below is None

    def describe(self, phrases: Phrases) -> str:
        if not self._is_plain_half():
            return super().describe(phrases)
        half = phrases.period
        if self.at_least is not None and self.at_least == self.at_most:
            which = f"{half} {self.at_least}"
        elif self.at_least is not None and self.at_most is not None:
            which = f"one of the {phrases.period.many} {self.at_least} to {self.at_most}"
        elif self.at_least is not None:
            which = f"{half} {self.at_least} or a later one"
        else:
            which = f"{half} {self.equals}" if self.at_most is None else f"{half} {self.at_most} or an earlier one"
        return f"it is {'not ' if self.negate else ''}{which}"
