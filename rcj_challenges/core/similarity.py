"""Similar names: the only place that compares names letter by letter.

Comparing costs the product of two lengths, times the number of names. Names come from strangers, so both are bounded.
"""

from __future__ import annotations

from collections.abc import Iterable
from difflib import SequenceMatcher, get_close_matches
from itertools import islice

MAX_COMPARED = 150
"""How many known names a misspelt one is compared with; among more the intended one would be a guess."""

MAX_CHARACTERS = 32
"""How many characters of a name are compared; a difference only after them is not a typing mistake."""


def nearest_name(word: str, known: Iterable[str], least: float = 0.6) -> str | None:
    """Return the known name that is most similar to a misspelt one; None if none is similar.

    The first `MAX_COMPARED` known names count; the required similarity is from 0 to 1.
    """
    by_beginning: dict[str, str] = {}
    for name in islice(known, MAX_COMPARED):
        by_beginning.setdefault(name[:MAX_CHARACTERS], name)
    found = get_close_matches(word[:MAX_CHARACTERS], by_beginning, 1, least)
    return by_beginning[found[0]] if found else None


def similarity(one: str, other: str) -> float:
    """Return the similarity of two names, from 0 to 1."""
    return SequenceMatcher(None, one[:MAX_CHARACTERS], other[:MAX_CHARACTERS]).ratio()
