"""The condition ``half``."""

from typing import Literal

from rcj_challenges.rules.base import Binder, Condition, Phrases, Test
from rcj_challenges.rules.fields import described


class HalfIs(Condition):
    """Which half of the match is being played."""

    condition: Literal["half"]
    at_least: int | None = described(None, "holds in this half and later ones", ge=1)
    at_most: int | None = described(None, "holds in this half and earlier ones", ge=1)
    equals: int | None = described(None, "holds in this half only", ge=1)

    EXCLUDES = (("equals", ("at_least", "at_most")),)
    REQUIRES = (("at_least",), ("at_most",), ("equals",))
    EXAMPLE = """
match: {halves: 2, half_s: 60}
rules:
  goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions: [{action: score, entrant: yellow}]
  late_goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    # From the second half on, a goal gives one point more.
    conditions: [{condition: half, at_least: 2}]
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
        return self.at_least == 1 and self.at_most is None and not self.negate

    def test(self, to: Binder) -> Test:
        half = to.state.half.half
        is_now = (
            (self.at_least is None or half >= self.at_least)
            and (self.at_most is None or half <= self.at_most)
            and (self.equals is None or half == self.equals)
        )
        return lambda: is_now

    def describe(self, phrases: Phrases) -> str:
        if self.at_least is not None and self.at_least == self.at_most:
            which = f"half {self.at_least}"
        elif self.at_least is not None and self.at_most is not None:
            which = f"one of the halves {self.at_least} to {self.at_most}"
        elif self.at_least is not None:
            which = f"half {self.at_least} or a later one"
        else:
            which = f"half {self.equals}" if self.at_most is None else f"half {self.at_most} or an earlier one"
        return f"it is {'not ' if self.negate else ''}{which}"
