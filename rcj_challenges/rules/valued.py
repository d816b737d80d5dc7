"""What is said of a value in its own mapping: how it compares, or that it ranks."""

from typing import Any, ClassVar, TypeVar, cast

from pydantic import create_model

from rcj_challenges.rules.fields import Strict
from rcj_challenges.rules.number import NumberValue

_V = TypeVar("_V", bound="Valued")


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
