"""The list of conditions, and conditions that must all hold, or of which one must hold."""

from collections.abc import Sequence
from typing import Annotated

from pydantic import Field

from rcj_challenges.rules.base import Binder, Condition, KeyedVocabulary, Phrases, Test
from rcj_challenges.rules.fields import Names
from rcj_challenges.rules.phrasing import listed

CONDITIONS = KeyedVocabulary({}, lambda _value: None)
AnyCondition = Annotated[Condition, CONDITIONS]

_ALTERNATIVES = CONDITIONS.beside(
    {},
    lambda value: "list" if isinstance(value, list | tuple) else None,
    rest={"list": Annotated[tuple[AnyCondition, ...], Field(min_length=1)]},
)
Alternative = Annotated[Condition | tuple[Condition, ...], _ALTERNATIVES]
"""One of several of which one must hold: a condition, or a list of which all must hold."""


class AllHold(Condition):
    """Several conditions that must all hold: a list of them."""

    conditions: tuple[Condition, ...]

    def is_several(self) -> bool:
        return len(self.conditions) > 1

    def is_always(self) -> bool:
        return all(one.is_always() for one in self.conditions)

    def compares_with_value(self) -> bool:
        return any(one.compares_with_value() for one in self.conditions)

    def test(self, to: Binder) -> Test:
        tests = tuple(condition.compile(to) for condition in self.conditions)
        return tests[0] if len(tests) == 1 else lambda: all(test() for test in tests)

    def watched(self, to: Binder) -> tuple[int, ...]:
        return watched_by(to, self.conditions)

    def about(self) -> Names | None:
        return self.conditions[0].about() if len(self.conditions) == 1 else None

    def describe(self, phrases: Phrases) -> str:
        # Not all of them hold: of one the opposite does.
        return one_holds(phrases, opposites(self.conditions)) if self.negate else all_hold(phrases, self.conditions)


def as_one(conditions: Condition | tuple[Condition, ...]) -> Condition:
    """Return a list of conditions of which all must hold as one."""
    if isinstance(conditions, Condition):
        return conditions
    return AllHold.model_construct(conditions=conditions) if len(conditions) > 1 else conditions[0]


def watched_by(to: Binder, conditions: Sequence[Condition]) -> tuple[int, ...]:
    """Return the entities whose placement changes any of several conditions."""
    return tuple(dict.fromkeys(entity for condition in conditions for entity in to.watched(condition)))


def opposites(conditions: Sequence[Condition]) -> list[Condition]:
    """Return the opposite of each condition."""
    return [one.model_copy(update={"negate": not one.negate}) for one in conditions]


def all_hold(phrases: Phrases, parts: Sequence[Condition]) -> str:
    """Return that all of several conditions hold."""
    # Behind a comma it is clear that it does not belong to the alternatives before it.
    joint = ", and " if any(one.is_several() for one in parts) else " and "
    return joint.join(one.describe(phrases) for one in parts)


def one_holds(phrases: Phrases, parts: Sequence[Condition]) -> str:
    """Return that one of several conditions holds."""
    if len(parts) == 1:
        return parts[0].describe(phrases)
    inner = [_within(phrases, one) for one in parts]
    return "either " + (", or " if any(one.is_several() for one in parts) else " or ").join(inner)


def _within(phrases: Phrases, condition: Condition) -> str:
    """Return a condition as one of several; if all of others must hold in it, as ``both … and …``."""
    if not isinstance(condition, AllHold) or condition.negate:
        return condition.describe(phrases)
    inner = [one.describe(phrases) for one in condition.conditions]
    return f"both {inner[0]} and {inner[1]}" if len(inner) == 2 else f"{listed(inner, 'and')} at once"
