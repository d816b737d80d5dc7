"""Names of what was removed from a base: where that was, for messages to who still uses them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from rcj_challenges.scenario.tree import Entries, Mark, Path, mark_of


class Removal(NamedTuple):
    """Where a name was removed that something else still has.

    Attributes:
        told: the words for it.
        is_by_base: whether a base has removed it, and the scenario's own file names it, for whose author it never was.
    """

    told: str
    is_by_base: bool


def removal_of(
    name: str, sections: Iterable[str], removed: Mapping[Path, Mark], mark: Mark, root: Entries
) -> Removal | None:
    """Return where an entry was removed; None: there was none.

    Args:
        name: of the entry.
        sections: in any of which it may have been.
        removed: where entries of a base were removed.
        mark: where it is still named.
        root: the whole scenario.
    """
    at = next((removed[section, name] for section in sections if (section, name) in removed), None)
    if at is None:
        return None
    where = f"{at.file}:{at.line}" if at.line else at.file
    # What the command line takes away has no line, and was there.
    is_by_base = bool(at.line) and at.file != mark.file == mark_of(root, ("id",)).file
    return Removal(f"it was removed in {where}", is_by_base)
