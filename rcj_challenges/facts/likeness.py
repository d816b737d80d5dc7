"""Names that are nearly another one: the only place that compares them letter by letter.

Comparing costs the product of two lengths, times the number of names. Names come from strangers, so both are bounded.
"""

from __future__ import annotations

from collections.abc import Iterable
from difflib import SequenceMatcher, get_close_matches
from itertools import islice

MAX_COMPARED = 150
"""Known names that a misspelt one is compared with; among more the intended one is a guess."""

MAX_LETTERS = 32
"""Letters of a name that are compared; what differs only behind them is no typing mistake."""


def nearest_name(word: str, known: Iterable[str], likeness: float = 0.6) -> str | None:
    """Return the known name that is most like a misspelt one; None if none is like it.

    Args:
        word: as it was written.
        known: the names that there are; the first `MAX_COMPARED` count.
        likeness: how like it a name must be, from 0 to 1.
    """
    by_beginning: dict[str, str] = {}
    for name in islice(known, MAX_COMPARED):
        by_beginning.setdefault(name[:MAX_LETTERS], name)
    found = get_close_matches(word[:MAX_LETTERS], by_beginning, 1, likeness)
    return by_beginning[found[0]] if found else None


def likeness_of(one: str, other: str) -> float:
    """Return how like each other two names are, from 0 to 1."""
    return SequenceMatcher(None, one[:MAX_LETTERS], other[:MAX_LETTERS]).ratio()
