"""The action ``end``."""

from typing import Literal

from rcj_challenges.rules.base import Act, Action, Binder, Firing, Phrases
from rcj_challenges.rules.effects import Ends
from rcj_challenges.rules.fields import described


class End(Action):
    """End the half after the last firing of this tick."""

    action: Literal["end"]
    what: Literal["half", "match"] = described(
        "half",
        "half: the next half still follows; match: no half follows, even if this one is already over (half_ended)",
    )
    reason: str = described("", "the reason, for the record", max_length=200)

    EFFECT = Ends
    EXAMPLE = """
rules:
  golden_goal:
    triggers: [{trigger: enters, entity: ball, zone: blue_goal}]
    actions: [{action: score, entrant: yellow}, {action: end, what: match, reason: golden goal}]
  over:
    phases: any
    triggers: [{trigger: half_ended}]
    actions: [{action: emit, event: OVER}]
expect:
  the_first_goal_ends_it:
    keyframes: [{at_s: 1, place: {ball: [0, 0.8]}}]
    lasts_s: 10
    events: [{event: OVER, at_s: 1}]
    score: {yellow: 1}
"""

    def compile(self, to: Binder) -> Act:
        """Return a function that ends the half, or the match, after the last firing of this tick.

        The first reason stands, but one for the end of the match goes before one for the end of the half.
        """
        state, reason, is_match = to.state, self.reason or to.rule.name, self.what == "match"

        def act(_firing: Firing) -> None:
            if state.ended is None or (is_match and not state.match_over):
                state.ended = reason
            state.match_over = state.match_over or is_match

        return act

    def describe(self, phrases: Phrases) -> str:
        what = phrases.period if self.what == "half" else self.what
        return f"the {what} ends" + (f" ({self.reason})" if self.reason else "")
