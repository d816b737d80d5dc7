"""The value ``lowest``."""

from collections.abc import Sequence

from rcj_challenges.rules.base import Number
from rcj_challenges.rules.fields import described
from rcj_challenges.rules.values.folded import FoldedValue, Several
from rcj_challenges.rules.values.highest import HighestValue


class LowestValue(FoldedValue):
    """The lowest of several numbers; none if there are none."""

    lowest: Several = described(..., "a value that names a group or others, read of each of them; or a list of numbers")

    KEY = "lowest"
    EXAMPLE = HighestValue.EXAMPLE

    def fold(self, numbers: Sequence[Number]) -> Number | None:
        return min(numbers, default=None)
