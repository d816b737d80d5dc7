"""Conditions that compare a value that is a number with other numbers."""

from collections.abc import Callable
from operator import eq, ge, gt, le, lt
from typing import Any, ClassVar, NamedTuple

from rcj_challenges.core.amounts import round_score
from rcj_challenges.rules.base import Binder, Condition, Firing, Number, Phrases, Test, ValueWord
from rcj_challenges.rules.fields import Name, Names, Point, described
from rcj_challenges.rules.number import Amount, NumberValue, Valued, amount_words, compile_amount, with_keys_of
from rcj_challenges.rules.phrasing import Clause
from rcj_challenges.rules.quantifier import Quantifier, quantified


class _Bound(NamedTuple):
    """What a key compares.

    Attributes:
        says, opposite: in words; empty: its opposite has none.
    """

    holds: Callable[[Number, Number], bool]
    says: str
    opposite: str


_BOUNDS = {
    "at_least": _Bound(ge, "at least", "less than"),
    "at_most": _Bound(le, "at most", "more than"),
    "above": _Bound(gt, "more than", "at most"),
    "below": _Bound(lt, "less than", "at least"),
    "equals": _Bound(eq, "exactly", ""),
}


class Compared(Valued, Condition):
    """A value that is a number, compared with one bound at least; of a fact without a bound, whether it is so.

    Attributes:
        IS_PART: that the schema defines these fields once for all such conditions.
    """

    EXCLUDES: ClassVar[tuple[tuple[str, tuple[str, ...]], ...]] = (
        ("equals", ("at_least", "at_most", "above", "below")),
        ("above", ("at_least",)),
        ("below", ("at_most",)),
    )
    REQUIRES: ClassVar[tuple[tuple[str, ...], ...]] = tuple((key,) for key in _BOUNDS)
    IS_PART: ClassVar = True

    at_least: Amount | None = described(None, "holds at this number and above")
    at_most: Amount | None = described(None, "holds at this number and below")
    above: Amount | None = described(None, "holds above this number, not at it")
    below: Amount | None = described(None, "holds below this number, not at it")
    equals: Amount | None = described(None, "holds at exactly this number")
    of: Quantifier | None = described(
        None,
        "of how many members of a group it must be true, any if omitted; if what is kept per entity is read without "
        "entity: of how many of all",
    )

    def grouped(self) -> Names | None:
        """Return the names of which it must hold of so many; None: it names none."""
        return getattr(self, self.VALUE.OVER) if self.VALUE.OVER else None

    def limits(self) -> list[tuple[_Bound, Amount]]:
        """Return with what it compares, and how."""
        return [(bound, limit) for key, bound in _BOUNDS.items() if (limit := getattr(self, key)) is not None]

    def compares_with_value(self) -> bool:
        """Return whether it compares with a value, not with a number."""
        return any(isinstance(limit, ValueWord) for _, limit in self.limits())

    def is_always(self) -> bool:
        """Return whether it holds at any time."""
        return self.value.holds_always(self)

    def about(self) -> Names | None:
        """Return the entities whose place it reads, if it names them."""
        return self.value.about()

    def distances_m(self) -> tuple[tuple[Name | Point, float], ...]:
        """Return the fixed distances in m that it compares with, each with the name or point it is measured from."""
        origin = None if self.value.is_computed() else self.value.measured_from()
        limits = () if origin is None else (limit for _, limit in self.limits())
        return tuple((origin, float(one)) for one in limits if origin and isinstance(one, int | float) and one > 0)

    # --- for the referee ----------------------------------------------------------------------------------------------

    def test(self, to: Binder) -> Test:
        """Return the test of the comparison, or of the fact."""
        if not self.limits():
            return self.test_of_each(to, lambda value: value.fact(to))
        holds = self.comparison(to)
        return self.test_of_each(to, lambda value: _test(value, to, holds))

    def test_of_each(self, to: Binder, test_of: Callable[[NumberValue], Callable[[], Any]]) -> Test:
        """Return the test of one value, or of so many members of a group as are asked for; it passes over none."""
        value = self.value
        names = value.named() if self.of is None else value.names(to)
        if not names:
            return test_of(value)
        members, members_now = value.members(to, names)
        tests = {member: test_of(value.of_member(member)) for member in members}
        of = self.of or "any"
        if of == "any" and len(tests) == 1 and members_now() is members:
            return next(iter(tests.values()))
        return lambda: quantified(of, (holds for member in members_now() if (holds := tests[member]()) is not None))

    def comparison(self, to: Binder) -> Callable[[Number], bool]:
        """Return a function that compares a number with the bounds."""
        digits = self.VALUE.DIGITS
        tests = tuple(_comparison(bound.holds, limit, to, digits) for bound, limit in self.limits())
        if len(tests) == 1:
            return tests[0]
        return lambda value: all(test(value) for test in tests)

    def watched(self, to: Binder) -> tuple[int, ...]:
        """Return the entities whose placement changes it."""
        return self.value.places(to)

    # --- for the sheet ------------------------------------------------------------------------------------------------

    def describe(self, phrases: Phrases) -> str:
        """Return the comparison as the part of a sentence that follows ``if``."""
        value = self.value
        clause = None if value.is_computed() else value.clause(phrases)
        is_of_one = clause and isinstance(clause.names, str) and not phrases.is_several(clause.names)
        if clause and not (clause.unit and self.compares_with_value() and is_of_one):
            return self._describe_clause(phrases, clause)
        if not value.is_computed() and (words := value.describe_compared(phrases, self)):
            return words
        number = amount_words(phrases, value)
        if isinstance(self.equals, ValueWord):
            return f"{number} {'differs from' if self.negate else 'is equal to'} {amount_words(phrases, self.equals)}"
        if self.negate and (opposite := self.opposite(phrases)):
            return f"{number} is {opposite}"
        return f"{number} is {'not ' if self.negate else ''}{self.compared(phrases)}"

    def _describe_clause(self, phrases: Phrases, clause: Clause) -> str:
        subject = phrases.quantified(self.of or "any", clause.names, negate=self.negate)
        opposite = self.opposite(phrases, clause.unit) if subject.negated else None
        if opposite is None:
            compared = self.compared(phrases, clause.unit, clause.where)
            return f"{subject.does(clause.does, clause.do)} {clause.how.format(compared)}"
        off = clause.or_off if phrases.may_be_off() else ""
        return f"{subject.text} {clause.does} {clause.how.format(opposite + clause.where)}{off}"

    def compared(self, phrases: Phrases, unit: str = "", where: str = "") -> str:
        """Return the comparison: ``at least 3 and at most 5``, ``at most 0.5 m from the ball``."""
        limits = self.limits()
        if all(isinstance(limit, int | float) for _, limit in limits):
            numbers = " and ".join(f"{bound.says} {amount_words(phrases, limit)}{unit}" for bound, limit in limits)
            return f"{numbers}{where}" if numbers else ""
        return " and ".join(
            f"{bound.says} {amount_words(phrases, limit)}{unit}{where}"
            if isinstance(limit, int | float) or not unit
            else f"{bound.says} as many{unit}{where} as {amount_words(phrases, limit)} says"
            for bound, limit in limits
        )

    def opposite(self, phrases: Phrases, unit: str = "") -> str | None:
        """Return the opposite of a comparison that has one limit: ``less than 0.5 m``; None if it cannot be put so."""
        (bound, limit), *more = self.limits() or [(_BOUNDS["equals"], 0)]
        if more or not bound.opposite or (unit and not isinstance(limit, int | float)):
            return None
        return f"{bound.opposite} {amount_words(phrases, limit)}{unit}"


def _test(value: NumberValue, to: Binder, holds: Callable[[Number], bool]) -> Test:
    """Return the test of one value; None if there is no such number."""
    read, firing = value.exact(to), Firing(to.rule, None, "")

    def test() -> Any:
        number: Number | None = read(firing)
        return None if number is None else holds(number)

    return test


def _comparison(
    operate: Callable[[Number, Number], bool], limit: Amount, to: Binder, digits: int | None
) -> Callable[[Number], bool]:
    """Return a function that compares a number with a limit, with a value as it would be counted; with none: never."""
    if isinstance(limit, int | float):
        constant = round_score(limit) if digits is None else limit
        return lambda value: operate(value, constant)
    read, firing = compile_amount(limit, to), Firing(to.rule, None, "")

    def compare(value: Number) -> bool:
        other: Number | None = read(firing)
        return other is not None and operate(value if digits is None else round(value, digits), other)

    return compare


def comparison_of(value: type[NumberValue]) -> type[Compared]:
    """Return the condition that compares a value, with the keys of both; its example is that of the value."""
    model = with_keys_of(value, Compared, "Is")
    model.REQUIRES = value.REQUIRES if value.IS_FACT else Compared.REQUIRES
    return model
