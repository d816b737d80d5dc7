"""A part of a sum: a value times a weight, ``{counter: laps, weight: 10}``."""

from collections.abc import Callable
from functools import cache
from typing import Any, cast

from pydantic import create_model

from rcj_challenges.rules.base import KeyedVocabulary, ValueWord, Word
from rcj_challenges.rules.fields import described


class Term(ValueWord):
    """A part of a sum: any value that is a number, with a weight next to its own keys."""

    ALL_IF_NONE = True

    weight: float = described(
        1.0, "factor by which the value is multiplied; for a flag: the amount that counts if it is set"
    )


@cache
def term_of(value: type[ValueWord]) -> type[Term]:
    """Return the model of a value with a weight next to its own keys."""
    doc = f"A part of a sum: the value `{value.KEY}` times a weight."
    bases: Any = (Term, value)
    model: Any = create_model(f"Weighted{value.__name__}", __base__=bases, __module__=__name__, __doc__=doc)
    return cast("type[Term]", model)


class Terms(KeyedVocabulary):
    """The values of another vocabulary, each with a weight, and plain numbers."""

    def __init__(self, values: Callable[[], tuple[type[Word], ...]]) -> None:
        super().__init__({"number": int | float}, lambda _value: "number")
        self._values = values

    def words(self) -> tuple[type[Word], ...]:
        return tuple(term_of(word) for word in self._values() if issubclass(word, ValueWord))
