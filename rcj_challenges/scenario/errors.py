"""What is wrong with a scenario: all of it at once, each with a code, its place in the file, and what to do."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import islice

from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError, InFile
from rcj_challenges.core.similarity import MAX_COMPARED, nearest_name

MAX_FOUND = 300
"""How many mistakes a search collects before it stops: more would not help, and cost time."""

_MAX_CHARACTERS = 64
"""How much of a name is shown: as long as one may be."""


class ScenarioError(DiagnosticError):
    """A scenario cannot be used; its diagnostics stand in the order of files and positions, each once."""

    def __init__(self, problems: Iterable[Diagnostic]) -> None:
        unique = dict.fromkeys(problems)
        ranks = {file: rank for rank, file in enumerate(dict.fromkeys(place_of(one).file for one in unique))}

        def position(one: Diagnostic) -> tuple[int, int, int, str, str]:
            place = place_of(one)
            return ranks[place.file], place.line or 0, place.column or 0, place.path, one.message

        super().__init__(*sorted(unique, key=position))


def place_of(problem: Diagnostic) -> InFile:
    """Return the place of a mistake in a file; an empty one if it has none."""
    return problem.where if isinstance(problem.where, InFile) else InFile("")


_OPPOSITES = (frozenset({"any", "all", "none"}), frozenset({"min", "most"}), frozenset({"max", "least"}))
"""Parts of words that reverse their meaning: a word with one of them is not suggested for a word with another."""


def nearest(word: str, known: Iterable[str]) -> str | None:
    """Return the known word that is most like a misspelt one; None if none is like it."""
    folded: dict[str, str] = {}
    written = set(word.casefold().split("_"))
    for name in islice(known, MAX_COMPARED):
        if not any(written & words and (words - written) & set(name.casefold().split("_")) for words in _OPPOSITES):
            folded.setdefault(name.casefold(), name)
    if word.casefold() in folded:
        return folded[word.casefold()]
    without_unit = next((name for name in folded if name.startswith(f"{word.casefold()}_")), None)
    found = without_unit or nearest_name(word.casefold(), folded)
    return None if found is None else folded[found]


def did_you_mean(word: str, known: Iterable[str], then: str = "") -> str:
    """Return ``did you mean 'x'?``, unless nothing is alike, and then a text; arguments as for `nearest`."""
    name = nearest(word, known)
    return then if name is None else f"did you mean '{name}'? {then}".rstrip()


def choice_of(word: str, known: Iterable[str], noun: str = "") -> str:
    """Return the known word that is most like a misspelt one, and all known words.

    The noun says what they name, ``zone``; it is empty for words of the language.
    """
    names = list(known)
    if not names:
        return f"this scenario has no {noun}" if noun else ""
    return did_you_mean(word, names, f"allowed here: {listing(names, 40)}")


def cut(text: str) -> str:
    """Return a name or text as long as a name may be; one without a letter as quotes."""
    if not text.strip():
        return "''"
    return text if len(text) <= _MAX_CHARACTERS else f"{text[: _MAX_CHARACTERS - 4]}…"


def listing(names: Iterable[str], most: int = 12) -> str:
    """Return names as a list for a sentence, in their order, cut after ``most``."""
    known = list(names)
    more = f", … ({len(known)} in all)" if len(known) > most else ""
    return ", ".join(known[:most]) + more
