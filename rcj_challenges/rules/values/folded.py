"""What ``highest``, ``lowest`` and ``sum`` share: one number of several."""

from collections.abc import Callable, Sequence
from typing import Annotated

from pydantic import Field

from rcj_challenges.rules.base import Firing, Number, Phrases, Reader, Scope, ValueWord
from rcj_challenges.rules.number import NUMBERS, Amount, NumberValue, as_one_number, read_number, scored
from rcj_challenges.rules.phrasing import listed

_SEVERAL = NUMBERS.beside(
    {},
    lambda value: "list" if isinstance(value, list | tuple) else None,
    rest={"list": Annotated[tuple[Amount, ...], Field(min_length=1)]},
)
Several = Annotated[ValueWord | tuple[Amount, ...], _SEVERAL]
"""Numbers: a list of them, or a value that names a group, of each member."""


class FoldedValue(NumberValue):
    """One number of several, which passes over none."""

    def as_it_is(self, to: Scope) -> Reader:
        return scored(self.measure(to))

    def measure(self, to: Scope) -> Reader:
        read_all = self._read_all(to)
        return lambda firing: self.fold([one for one in read_all(firing) if one is not None])

    def fold(self, numbers: Sequence[Number]) -> Number | None:
        """Return the one number of several."""
        raise NotImplementedError

    def several(self) -> NumberValue | tuple[Amount, ...]:
        """Return the numbers as they are written."""
        several: NumberValue | tuple[Amount, ...] = getattr(self, self.KEY)
        return several

    def _read_all(self, to: Scope) -> Callable[[Firing], Sequence[Number | None]]:
        several = self.several()
        if isinstance(several, tuple):
            readers = tuple(read_number(one, to) for one in several)
            return lambda firing: [read(firing) for read in readers]
        members, members_now = several.members(to, several.names(to))
        of = {member: read_number(several.of_member(member), to) for member in members}
        return lambda firing: [of[member](firing) for member in members_now()]

    def describe(self, phrases: Phrases) -> str:
        several = self.several()
        if isinstance(several, tuple):
            return f"the {self.KEY} of {listed([as_one_number(phrases, one) for one in several], 'and')}"
        return f"the {self.KEY}{' of the' if self.KEY == 'sum' else ''} {several.describe_each(phrases)}"
