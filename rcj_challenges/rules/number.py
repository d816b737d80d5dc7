"""Values that are numbers: what may stand beside each of them, and what none is.

None is the number of what does not exist: the place of what is off the field, the message that never came, the lowest
of an empty group. Calculating with none gives none, unless ``otherwise`` stands there.
"""

from collections.abc import Callable
from math import ceil, floor
from operator import add, mul, sub
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, NamedTuple, Self, TypeVar, cast

from pydantic import Field, create_model

from rcj_challenges.core.amounts import clamp_to_max, plain, round_score
from rcj_challenges.rules.base import Binder, Firing, KeyedVocabulary, Number, Phrases, Reader, Scope, ValueWord
from rcj_challenges.rules.fields import Name, Names, Point, Strict, described
from rcj_challenges.rules.phrasing import Clause, number

if TYPE_CHECKING:
    from rcj_challenges.rules.comparison import Compared

_V = TypeVar("_V", bound="Valued")

NUMBERS = KeyedVocabulary({"number": int | float}, lambda _value: "number")
Amount = Annotated[int | float | ValueWord, NUMBERS]
"""A number: written as one, or a value that is one. It may stand wherever a rule has a number."""

_ROUNDED: dict[str | None, Callable[[float], int]] = {
    "down": floor,
    "up": ceil,
    "nearest": lambda value: floor(value + 0.5),
}
_ALONE = dict.fromkeys(("otherwise", "times", "plus", "minus", "round_"))
_STEPS: tuple[tuple[str, Callable[[Number, Number], Number]], ...] = (("times", mul), ("plus", add), ("minus", sub))


class NumberValue(ValueWord):
    """What may stand beside a value that is a number; worked out in this order.

    Attributes:
        IS_PART: that the schema defines these fields once for all such values.
        OVER: the field in which ``highest``, ``lowest`` and ``sum`` put each member of a group; empty: it has none.
        DIGITS: to how many digits behind the point it is sent, counted and compared with another value; None: to all.
        IS_FACT: whether it is a condition without a comparison too.
    """

    IS_PART: ClassVar = True
    OVER: ClassVar = ""
    DIGITS: ClassVar[int | None] = None
    IS_FACT: ClassVar = False

    otherwise: Amount | None = described(
        None, "the number where there is none: of what is off the field, or was never sent"
    )
    times: Amount | None = described(None, "times this number; none if either is none")
    plus: Amount | None = described(None, "plus this number; none if either is none")
    minus: Amount | None = described(None, "minus this number; none if either is none")
    round_: Literal["down", "up", "nearest"] | None = Field(
        None, alias="round", description="rounded to a whole number; nearest: halves upwards; if omitted: not rounded"
    )

    # --- for the referee ----------------------------------------------------------------------------------------------

    def measure(self, to: Scope) -> Reader:
        """Return a function that reads it as an exact number, without what stands beside it; None: there is none."""
        raise NotImplementedError

    def as_it_is(self, to: Scope) -> Reader:
        """Return a function that reads the value without what stands beside it; it can be written as JSON."""
        exact = self.measure(to)
        if (digits := self.DIGITS) is None:
            return exact
        return lambda firing: None if (number := exact(firing)) is None else round(number, digits)

    def read(self, to: Scope) -> Reader:
        """Return a function that reads the value; it can be written as JSON."""
        return compile_amount(self, to) if self.is_computed() else self.as_it_is(to)

    def number(self, to: Scope) -> Reader:
        """Return a function that works out the number, not rounded to what scores and counters have; None: none."""
        measure = self.measure(to) if self.DIGITS is None else self.as_it_is(to)
        if not self.is_computed():
            return measure
        otherwise = None if self.otherwise is None else read_number(self.otherwise, to)
        operands = ((operate, getattr(self, key)) for key, operate in _STEPS)
        steps = tuple((operate, read_number(operand, to)) for operate, operand in operands if operand is not None)
        rounded = _ROUNDED.get(self.round_)

        def work_out(firing: Firing) -> Number | None:
            value: Number | None = measure(firing)
            if value is None and otherwise is not None:
                value = otherwise(firing)
            for operate, read in steps:
                operand = read(firing)
                if value is None or operand is None:
                    return None
                value = clamp_to_max(operate(value, operand))  # each time: ∞ - ∞ would be no number
            # What is 3 on paper must not be rounded down to 2.
            return value if value is None or rounded is None else rounded(round_score(value))

        return work_out

    def exact(self, to: Scope) -> Reader:
        """Return a function that reads the number as it is compared: as measured, unless something stands beside it."""
        return self.number(to) if self.is_computed() else self.measure(to)

    def places(self, _to: Scope) -> tuple[int, ...]:
        """Return the entities whose placement changes it."""
        return ()

    def is_computed(self) -> bool:
        """Return whether anything stands beside it."""
        return self.round_ is not None or any(
            one is not None for one in (self.otherwise, self.times, self.plus, self.minus)
        )

    def alone(self) -> Self:
        """Return it without what stands beside it."""
        return self.model_copy(update=_ALONE)

    def names(self, _to: Scope) -> Names:
        """Return the names that stand where ``highest``, ``lowest`` and ``sum`` put each member."""
        return self.named()

    def members(self, to: Scope, names: Names) -> tuple[tuple[str, ...], Callable[[], tuple[str, ...]]]:
        """Return all members that the names may stand for, and a function that finds those for which they do now."""
        return to.group(names)

    def named(self) -> Names:
        """Return the names of what it is read of; none if it is read of all as one."""
        return getattr(self, self.OVER) if self.OVER else ()

    def of_member(self, member: str) -> Self:
        """Return the value of one member."""
        return self.model_copy(update={self.OVER: member})

    # --- as a condition -----------------------------------------------------------------------------------------------

    def fact(self, to: Binder) -> Callable[[], bool | None]:
        """Return the test of a value that is a fact; None: it is passed over."""
        raise NotImplementedError

    def about(self) -> Names | None:
        """Return the entities whose place it reads, if it names them."""
        return None

    def measured_from(self) -> Name | Point | None:
        """Return the name or point from which a distance is measured; None of any other value."""
        return None

    def holds_always(self, _by: "Compared") -> bool:
        """Return whether its comparison holds at any time."""
        return False

    def clause(self, _phrases: Phrases) -> Clause | None:
        """Return what its comparison says of things; None: as of all numbers."""
        return None

    def describe_compared(self, _phrases: Phrases, _by: "Compared") -> str:
        """Return its comparison as the part of a sentence that follows ``if``; empty: as of all numbers."""
        return ""

    # --- for the sheet ------------------------------------------------------------------------------------------------

    def describe_number(self, phrases: Phrases) -> str:
        """Return it in words where a number is asked for, without what stands beside it."""
        return self.describe(phrases)

    def describe_each(self, phrases: Phrases) -> str:
        """Return the value of each of several in words, as what follows ``the highest``."""
        return self.describe_number(phrases).removeprefix("the ")

    def describe_times(self, phrases: Phrases, factor: float) -> str:
        """Return the number times a factor: ``2 times the counter “laps”``."""
        words = self.describe_number(phrases)
        return words if factor == 1 else f"{number(factor)} times {words}"

    def terms(self) -> tuple["Term", ...]:
        """Return what is added up to it."""
        if self.round_ is not None or self.otherwise is not None or isinstance(self.times, ValueWord):
            return (Term(1, self),)
        own = Term(1 if self.times is None else self.times, self.alone())
        subtracted = () if self.minus is None else terms_of(self.minus)
        added = () if self.plus is None else terms_of(self.plus)
        return (*added, own, *(one.negated() for one in subtracted))

    def describe_whole(self, phrases: Phrases) -> str:
        """Return a value that is no plain sum in words, with all that stands beside it."""
        words = self.describe_number(phrases)
        if self.round_ == "down" and " in s" in words and self == self.model_copy(update=_ALONE | {"round_": "down"}):
            return words.replace(" in s", " in full seconds", 1)
        if self.otherwise is not None:
            words += f" ({amount_words(phrases, self.otherwise)} if there is none)"
        if isinstance(self.times, ValueWord):
            words += f" times {as_one_number(phrases, self.times)}"
        elif self.times is not None:
            words = f"{number(self.times)} times {words}"
        words += "" if self.plus is None else f", plus {as_one_number(phrases, self.plus)}"
        words += "" if self.minus is None else f", minus {as_one_number(phrases, self.minus)}"
        rounded = {"down": ", rounded down", "up": ", rounded up", "nearest": ", rounded", None: ""}
        return words + rounded[self.round_]


# --- what is said of them in their own mapping: how they compare, or that they rank -----------------------------------


class Valued(Strict):
    """A mapping with the keys of a value that is a number, and with others.

    Attributes:
        VALUE: the value.
        DEFINED_AS: where the schema defines all its other fields.
    """

    VALUE: ClassVar[type[NumberValue]]
    DEFINED_AS: ClassVar[type[NumberValue]]

    @property
    def value(self) -> NumberValue:
        """The value without the other keys."""
        return self.VALUE.model_construct(**by_key(self, self.VALUE))


def by_key(model: Strict, like: type[Strict]) -> dict[str, Any]:
    """Return the values of a model's fields, of those that another one has too, by the keys that the file uses."""
    return {info.alias or name: getattr(model, name) for name, info in like.model_fields.items()}


def with_keys_of(value: type[NumberValue], says: type[_V], suffix: str) -> type[_V]:
    """Return the model with the keys of a value and of what is said of it."""
    name, bases = f"{value.__name__.removesuffix('Value')}{suffix}", cast("Any", (says, value))
    doc = f"The value `{value.KEY}`."
    model = cast("Any", create_model(name, __base__=bases, __module__=__name__, __doc__=doc))
    model.VALUE = model.DEFINED_AS = value
    model.EXAMPLE = ""
    return cast("type[_V]", model)


# --- parts of sums ----------------------------------------------------------------------------------------------------


def as_number(value: object) -> Number | None:
    """Return a value that is a number; None if it is none."""
    return value if isinstance(value, int | float) else None


class Term(NamedTuple):
    """A part of a sum: a value times a factor, or the factor alone."""

    factor: float
    value: NumberValue | None

    def negated(self) -> "Term":
        """Return it with the opposite sign."""
        return self._replace(factor=-self.factor)

    def describe(self, phrases: Phrases, *, negate: bool, alone: bool) -> str:
        """Return it in words; ``negate``: its opposite."""
        factor = -self.factor if negate else self.factor
        if self.value is None:
            return number(factor)
        if not self.value.is_computed():
            return self.value.describe_times(phrases, factor)
        words = self.value.describe_whole(phrases)
        words = f"({words})" if ", " in words and not alone else words
        return words if factor == 1 else f"{number(factor)} times {words}"


# --- what the referee makes of them -----------------------------------------------------------------------------------


def compile_amount(amount: Amount, to: Scope) -> Reader:
    """Return a function that reads a number with the digits of a score; None: there is none."""
    read = read_number(amount, to)
    return scored(read) if isinstance(amount, NumberValue) else read


def scored(read: Reader) -> Reader:
    """Return a function that rounds what is read to the digits of a score."""

    def rounded(firing: Firing) -> Number | None:
        value: Number | None = read(firing)
        return None if value is None else round_score(value)

    return rounded


def read_number(amount: Amount, to: Scope) -> Reader:
    """Return a function that reads a number as it is worked out; None: there is none."""
    if isinstance(amount, NumberValue):
        return to.by_role(amount, lambda one: one.number(to), None)
    constant = plain(amount) if isinstance(amount, int | float) else None
    return lambda _firing: constant


# --- what the sheet says of them --------------------------------------------------------------------------------------


def terms_of(amount: Amount) -> tuple[Term, ...]:
    """Return what is added up to a number."""
    if isinstance(amount, NumberValue):
        return amount.terms()
    return (Term(amount, None),) if isinstance(amount, int | float) else ()


def amount_words(phrases: Phrases, amount: Amount, *, negate: bool = False) -> str:
    """Return a number in words: ``5, minus 0.1 times the time in full seconds``; ``negate``: its opposite."""
    terms = terms_of(amount)
    first, *more = terms
    said = first.describe(phrases, negate=negate, alone=not more)
    for term in more:
        is_less = (term.factor < 0) != negate
        said += ", minus " if is_less else ", plus "
        said += term.describe(phrases, negate=term.factor < 0, alone=False)
    return said


def takes_away(amount: Any) -> bool:
    """Return whether a number is calculated of parts that are all taken away."""
    return isinstance(amount, NumberValue) and all(term.factor < 0 for term in amount.terms())


def as_one_number(phrases: Phrases, amount: Amount) -> str:
    """Return a number in words as a part of others: in brackets if it is calculated of several."""
    words = amount_words(phrases, amount)
    return f"({words})" if ", " in words else words
