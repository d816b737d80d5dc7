"""The condition ``spot_free``."""

from typing import Annotated

from rcj_challenges.rules.base import Binder, Condition, Phrases, Test
from rcj_challenges.rules.fields import Name, Names, NotNegative, Point, described
from rcj_challenges.rules.phrasing import FREE_SPOT_NOTE, USUALLY_FREE_M, within_words
from rcj_challenges.rules.quantifier import Quantifier, quantified
from rcj_challenges.rules.refs import SPOTS


class SpotFree(Condition):
    """Whether a spot is free."""

    spot_free: Annotated[Names, SPOTS] = described(..., "a spot, or a group with `of`")
    of: Quantifier = described("any", "how many members of a group must be free")
    clearance_m: NotNegative = described(
        USUALLY_FREE_M, "the spot is free if no centre of a robot or ball is within this distance, in m"
    )

    KEY = "spot_free"
    NOTES = (FREE_SPOT_NOTE,)
    EXAMPLE = """
rules:
  room:
    triggers: [{trigger: time_reached, at_s: 2}]
    conditions: [{spot_free: centre, clearance_m: 0.1}]
    actions: [{action: emit, event: CENTRE_IS_FREE}]
expect:
  the_ball_is_gone:
    keyframes: [{at_s: 1, place: {ball: [0.5, 0]}}]
    lasts_s: 3
    events: [{event: CENTRE_IS_FREE}]
  the_ball_lies_there:
    keyframes: [{at_s: 1}]
    lasts_s: 3
    events: []
"""

    def test(self, to: Binder) -> Test:
        of, free = self.of, to.free_spots(self.spot_free, self.clearance_m)
        return lambda: quantified(of, free())

    def describe(self, phrases: Phrases) -> str:
        subject = phrases.quantified(self.of, self.spot_free, negate=self.negate).does("is", "are")
        return f"{subject} free{within_words(self.clearance_m)}"

    def distances_m(self) -> tuple[tuple[Name | Point, float], ...]:
        spots = (self.spot_free,) if isinstance(self.spot_free, str) else self.spot_free
        return tuple((spot, self.clearance_m) for spot in spots if self.clearance_m)
