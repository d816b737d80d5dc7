"""The list that the words of conditions are added to; conditions that are made of others need it before it is full."""

from typing import Annotated

from pydantic import Field

from rcj_challenges.rules.base import Condition, KeyedVocabulary

CONDITIONS = KeyedVocabulary({}, lambda _value: None)
AnyCondition = Annotated[Condition, CONDITIONS]

_ALTERNATIVES = CONDITIONS.beside(
    {},
    lambda value: "list" if isinstance(value, list | tuple) else None,
    rest={"list": Annotated[tuple[AnyCondition, ...], Field(strict=False, min_length=1)]},
)
Alternative = Annotated[Condition | tuple[Condition, ...], _ALTERNATIVES]
"""One of several of which one must hold: a condition, or a list of which all must hold."""
