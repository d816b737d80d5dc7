"""The action ``draw``."""

from typing import Annotated, Literal

from pydantic import Field

from rcj_challenges.rules.base import Act, Action, Binder, Phrases
from rcj_challenges.rules.effects import Draws
from rcj_challenges.rules.fields import Name, Scalar, described
from rcj_challenges.rules.phrasing import quoted_measure
from rcj_challenges.rules.refs import WRITTEN_DRAW, DrawnValue


class DrawAction(Action):
    """Draw again, or set a draw to a value."""

    action: Literal["draw"]
    draw: Annotated[Name, WRITTEN_DRAW] = described(..., "the draw")
    as_: Annotated[Scalar | None, DrawnValue(is_set=True)] = Field(
        None,
        alias="as",
        description="the value to set; each: the name of the for_each member; other: the name of the touched thing; if "
        "omitted: a random one",
    )

    EXAMPLE = """
draws: {side: {values: [left, right]}}
rules:
  decide:
    triggers: [{trigger: time_reached, at_s: 1}]
    # `as` sets the draw to this value.
    actions: [{action: draw, draw: side, as: left}, {action: emit, event: SIDE, payload: {side: {draw: side}}}]
expect:
  it_is_left_now:
    keyframes: [{at_s: 1}]
    lasts_s: 2
    events: [{event: SIDE, payload: {side: left}}]
"""

    def compile(self, to: Binder) -> Act:
        name = self.draw
        if self.as_ is None:
            return lambda _firing: to.assign_next(name)
        fixed = to.drawn_value(self.as_)
        return lambda _firing: to.assign(name, fixed)

    def effects(self) -> tuple[Draws]:
        return (Draws(self.draw, self.as_),)

    def describe(self, phrases: Phrases) -> str:
        if self.as_ is None:
            return f"{quoted_measure(self.draw)} is drawn again"
        value = phrases.drawn(self.draw, self.as_)
        # Of one that the rule is about people say what it becomes.
        if value.startswith("“"):
            return f"{quoted_measure(self.draw)} becomes {value}"
        return f"{value} becomes {quoted_measure(self.draw)}"
