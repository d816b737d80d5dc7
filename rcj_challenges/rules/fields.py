"""What all models of the scenario share: strictness, names, points and durations.

No module of this package says ``from __future__ import annotations``: pydantic would have to compile each of a thousand
annotations again at every start, which is a seventh of the time that ``validate`` takes.
"""

import copy
from typing import Annotated, Any, ClassVar, Literal, TypeGuard

from pydantic import (
    AfterValidator,
    BaseModel,
    BeforeValidator,
    ConfigDict,
    Field,
    GetCoreSchemaHandler,
    StringConstraints,
)
from pydantic_core import CoreSchema, PydanticCustomError, PydanticKnownError

from rcj_challenges.core.colours import hex_colour
from rcj_challenges.core.timing import TICK_S


class Strict(BaseModel):
    """Base of all models: unknown keys are refused, text is never taken for a number, nothing changes afterwards.

    Attributes:
        either: keys of which exactly one must be given; what a file gives takes the place of what its base gave.
        EXCLUDES: keys, each with those that cannot stand beside it.
        TOGETHER: keys, each with another one and the value of that with which (None: any), and only with which, it must
            be given.
        REQUIRES: sets of keys, of which one must be given.
        NOTES: what holds for all rules that use it, in sentences for the rule sheet.
    """

    either: ClassVar[tuple[str, ...]] = ()
    EXCLUDES: ClassVar[tuple[tuple[str, tuple[str, ...]], ...]] = ()
    TOGETHER: ClassVar[tuple[tuple[str, str, str | None], ...]] = ()
    REQUIRES: ClassVar[tuple[tuple[str, ...], ...]] = ()
    NOTES: ClassVar[tuple[str, ...]] = ()

    # Deferred: a validator is built for the whole file, and for each word that it has. Defaults that are models are
    # made by `model_construct`, which needs none.
    model_config = ConfigDict(extra="forbid", frozen=True, strict=True, allow_inf_nan=False, defer_build=True)


def described(default: Any, text: str, **bounds: Any) -> Any:
    """Return a pydantic field with its one-sentence description; ``...`` as default means required."""
    return Field(default, description=text, **bounds)


class BuiltOnce:
    """Marks a type that many fields have, so that pydantic works out its schema once; there is no model in it."""

    _schema: CoreSchema | None = None

    def __get_pydantic_core_schema__(self, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Return a copy of the marked type's schema: pydantic adds to it what a field says besides."""
        self._schema = self._schema or handler(source)
        return copy.copy(self._schema)


MAX_NAME_CHARACTERS = 64
NAME_RULE = f"letters a to z, digits and _, not beginning with a digit, at most {MAX_NAME_CHARACTERS} characters"
Name = Annotated[
    str,
    StringConstraints(pattern=r"^[A-Za-z_][A-Za-z0-9_]*$", max_length=MAX_NAME_CHARACTERS),
    Field(description=f"a name: {NAME_RULE}"),
    BuiltOnce(),
]
EventName = Annotated[
    str,
    StringConstraints(pattern=r"^[A-Z][A-Z0-9_]*$", max_length=MAX_NAME_CHARACTERS),
    Field(description="an event's name, in capitals: GOAL"),
]
DeviceName = Annotated[str, StringConstraints(min_length=1, max_length=MAX_NAME_CHARACTERS)]


def _known_colour(colour: str) -> str:
    """Return a colour as it is written; what no renderer could paint is refused."""
    if hex_colour(colour) is None:
        raise PydanticCustomError("unknown_colour", "no colour")
    return colour


Colour = Annotated[
    str,
    StringConstraints(pattern=r"^(#[0-9a-fA-F]{6}|[A-Za-z]{3,32})$"),
    AfterValidator(_known_colour),
    Field(description="a colour: a CSS colour name or #rrggbb"),
]
Scalar = str | int | float | bool


def _no_truth(value: Any) -> Any:
    """Return a number as it is; to Python true is 1, and would pass for it."""
    if isinstance(value, bool):
        raise PydanticKnownError("literal_error", {"expected": "a number"})
    return value


def _no_number(value: Any) -> Any:
    """Return true as it is; to Python 1 is true."""
    if isinstance(value, int | float) and not isinstance(value, bool):
        raise PydanticKnownError("literal_error", {"expected": "true"})
    return value


One = Annotated[Literal[1], BeforeValidator(_no_truth)]
OneOrMinusOne = Annotated[Literal[1, -1], BeforeValidator(_no_truth)]
Yes = Annotated[Literal[True], BeforeValidator(_no_number)]

Point = Annotated[
    tuple[float, float],
    Field(description="[x, y] in m; x along the short side, y along the long side, origin in the centre"),
    BuiltOnce(),
]
Positive = Annotated[float, Field(gt=0)]
NotNegative = Annotated[float, Field(ge=0)]
MM_DIGITS = 3
"""Measured lengths are counted, sent and compared with counters to the millimetre."""
LONGEST_S = 86_400
DurationS = Annotated[
    float, Field(ge=TICK_S, le=LONGEST_S, description="a duration in s, rounded up to ticks of 0.032 s")
]
WallTimeS = Annotated[float, Field(gt=0, le=86_400, description="time of the clock on the wall in s")]
Names = Annotated[
    Name | Annotated[tuple[Name, ...], Field(min_length=1)],
    Field(
        union_mode="left_to_right",
        description="a name, or a list of names; a group's name stands for its members",
    ),
    BuiltOnce(),
]


def is_named(what: Names | Point) -> TypeGuard[Names]:
    """Return whether something is given by its name, or by a list of names, and not as a point."""
    return isinstance(what, str) or isinstance(what[0], str)
