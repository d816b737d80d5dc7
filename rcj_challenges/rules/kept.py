"""Conditions on what is kept per entity: a counter, a flag, a timer or a sequence of one, of all, or of so many."""

from collections.abc import Callable
from typing import Any, Protocol

from rcj_challenges.rules.base import Binder, Phrases, Test
from rcj_challenges.rules.fields import Names
from rcj_challenges.rules.phrasing import Subject
from rcj_challenges.rules.quantifier import Quantifier, quantified


class _OfKept(Protocol):
    @property
    def negate(self) -> bool: ...
    @property
    def entity(self) -> Names | None: ...
    @property
    def of(self) -> Quantifier | None: ...


def test_of_kept(
    condition: _OfKept, to: Binder, section: str, name: str, kept: Any, test: Callable[[str | None], bool]
) -> Test:
    """Return the test of something kept per entity: of one, of all as one, or of so many of them.

    ``kept`` is a mapping by entity, or the single one; ``test`` gets None for all as one, and for the single one.
    """
    entity, of = condition.entity, condition.of
    if of is None and entity is None:
        (whose,) = to.owners(section, name, None) or (None,)
        return lambda: test(whose)
    keepers = tuple(kept) if isinstance(kept, dict) else ()
    members, members_now = to.group_of_owners(section, name, entity or keepers)
    if of is None and len(members) == 1 and members_now() is members:
        return lambda: test(members[0])
    return lambda: quantified(of or "any", (test(member) for member in members_now()))


def asked(phrases: Phrases, condition: _OfKept, kind: str, name: str) -> Subject | None:
    """Return the names of several that have a value each; None where one value is read, or all as one."""
    of, entity = condition.of, condition.entity
    if of is None and entity is None and phrases.one_of_owners(kind, name) == "each":
        return None
    together = of is None and entity is None and kind != "counter" and phrases.owners(kind, name) is not None
    is_one = entity is None or phrases.is_one_owner(kind, name, entity)
    if (of is None and is_one and not together) or entity == "each":
        return None
    return phrases.quantified(of or "any", entity or phrases.keepers(kind, name) or (), negate=condition.negate)


def kept(phrases: Phrases, condition: _OfKept, kind: str, name: str) -> str:
    """Return a counter, flag, timer or sequence with whose it is."""
    entity = condition.entity
    return phrases.kept(kind, name, entity if isinstance(entity, str) else None)
