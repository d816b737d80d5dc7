"""The condition ``draw``."""

from typing import Annotated

from rcj_challenges.rules.base import Binder, Condition, Phrases, Test
from rcj_challenges.rules.comparison import Compared, comparison_of
from rcj_challenges.rules.fields import Name, Scalar, described
from rcj_challenges.rules.phrasing import quoted_measure
from rcj_challenges.rules.refs import DRAW, DrawnValue
from rcj_challenges.rules.values import Amount
from rcj_challenges.rules.values.draw import DrawValue, NumberDraw

_BOUNDS = ("at_least", "at_most", "above", "below")
_NumberIs = comparison_of(NumberDraw)


class DrawIs(Condition):
    """The value of a draw, or how large it is, of a draw of numbers."""

    draw: Annotated[Name, DRAW] = described(..., "a draw")
    equals: Annotated[Scalar | None, DrawnValue()] = described(
        None,
        "the required value; each: the name of the for_each member; other: the name of the touched thing",
    )

    at_least: Amount | None = described(None, "holds at this number and above")
    at_most: Amount | None = described(None, "holds at this number and below")
    above: Amount | None = described(None, "holds above this number, not at it")
    below: Amount | None = described(None, "holds below this number, not at it")

    KEY = "draw"
    EXCLUDES = Compared.EXCLUDES
    REQUIRES = Compared.REQUIRES
    EXAMPLE = DrawValue.EXAMPLE

    def _bounded(self) -> Condition:
        """Return the comparison of the number."""
        given = {key: getattr(self, key) for key in ("draw", "negate", *_BOUNDS)}
        return _NumberIs.model_construct(**given)

    def test(self, to: Binder) -> Test:
        if self.equals is None:
            return self._bounded().test(to)
        draws, name, value = to.state.draws, self.draw, to.drawn_value(self.equals)
        return lambda: draws[name] == value

    def describe(self, phrases: Phrases) -> str:
        if self.equals is None:
            return self._bounded().describe(phrases)
        value, draw = phrases.drawn(self.draw, self.equals), quoted_measure(self.draw)
        return f"{value} was {'not ' if self.negate else ''}drawn as {draw}"
