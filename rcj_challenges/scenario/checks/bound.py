"""Whom the names ``each`` and ``other`` may stand for in a rule, while its tree is read."""

from __future__ import annotations

from typing import NamedTuple

from rcj_challenges.scenario.catalogue import BOUND, EACH, Catalogue, texts
from rcj_challenges.scenario.tree import Node


class Bound(NamedTuple):
    """Whom the names ``each`` and ``other`` may stand for; None where a name is not known.

    Attributes:
        each: the members of the rule's ``for_each``.
        other: what its triggers may find to be touched, if all of them are touches.
    """

    each: tuple[str, ...] | None = None
    other: tuple[str, ...] | None = None

    def of(self, name: str) -> tuple[str, ...] | None:
        """Return whom one of the two names stands for."""
        return self.each if name == EACH else self.other

    def meant(self, names: Node | None, catalogue: Catalogue) -> list[str]:
        """Return what names stand for: groups expanded, ``each`` and ``other`` replaced."""
        found = ((self.of(text) or ()) if text in BOUND else catalogue.expand(text) for text in texts(names))
        return [one for members in found for one in members]
