"""What is wrong with a scenario: every problem with its file, line, column and path in names."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from itertools import islice
from typing import Self

from rcj_challenges.facts.diagnostics import Diagnostic, InFile
from rcj_challenges.facts.errors import RcjError
from rcj_challenges.facts.likeness import MAX_COMPARED, nearest_name

_SHOWN = 100
"""More problems than a reader works through; a broken file of 1 MB could bring tens of thousands."""


MAX_FOUND = 300
"""How many problems a search for them collects before it stops: more help nobody, and cost time."""

_LONGEST = 64
"""How much of a name is shown: as long as one may be."""


@dataclass(frozen=True, slots=True)
class Problem:
    """One mistake.

    Attributes:
        file: as the reader knows it: the path as given, ``soccersim_v2.yaml`` for a preset, ``--set a=1``.
        line, column: 1-based; 0 where there is no line (the command line, a file that cannot be read).
        path: where in names, ``rules.goal.triggers[0] (enters)``; empty for the file as a whole.
        message: what was found, what is allowed, the nearest match.
    """

    file: str
    line: int
    column: int
    path: str
    message: str

    def __str__(self) -> str:
        where = f"{self.file}:{self.line}:{self.column}" if self.line else self.file
        return ": ".join(part for part in (where, self.path, self.message) if part)


class ScenarioError(RcjError):
    """A scenario cannot be used; ``str()`` is one line for each problem.

    Attributes:
        problems: all of them, by file and position, without repeats.
    """

    def __init__(self, problems: Iterable[Problem]) -> None:
        unique = dict.fromkeys(problems)
        order = {file: rank for rank, file in enumerate(dict.fromkeys(problem.file for problem in unique))}
        self.problems = sorted(unique, key=lambda p: (order[p.file], p.line, p.column, p.path, p.message))
        super().__init__(self._text())

    def _text(self) -> str:
        lines = [str(problem) for problem in self.problems[:_SHOWN]]
        if len(self.problems) > _SHOWN:
            lines.append(f"… and {len(self.problems) - _SHOWN} more")
        return "\n".join(lines)


class TooLargeError(ScenarioError):
    """A scenario has more of something than is read; ``str()`` has the form of `Diagnostic`.

    Attributes:
        diagnostic: what there is too much of.
    """

    def __init__(self, diagnostic: Diagnostic, problem: Problem) -> None:
        self.diagnostic = diagnostic
        super().__init__([problem])

    @classmethod
    def at(cls, file: str, line: int, column: int, message: str) -> Self:
        """Return the error at a place; without a line it is about the whole file."""
        diagnostic = Diagnostic("scenario-too-large", message, _SMALLER, InFile(file, line or None, column or None))
        return cls(diagnostic, Problem(file, line, column, "", message))

    def _text(self) -> str:
        return str(self.diagnostic)


_SMALLER = "leave out what the challenge does not need; repeat_for and groups say the same of several things at once"

_CONTRARY = (frozenset({"any", "all", "none"}), frozenset({"min", "most"}), frozenset({"max", "least"}))
"""Parts of words that turn their meaning over: who writes one does not mean a word with another of them."""


def nearest(word: str, known: Iterable[str], likeness: float = 0.6) -> str:
    """Return ``; did you mean 'x'?`` for the known word that is most like ``word``, or an empty text.

    Args:
        word: as it was written.
        known: the words that there are.
        likeness: how like it a word must be, from 0 to 1.
    """
    by_folded: dict[str, str] = {}
    written = set(word.casefold().split("_"))
    may_turn = [words for words in _CONTRARY if written & words]
    for name in islice(known, MAX_COMPARED):
        if not may_turn or not _is_contrary(written, name, may_turn):
            by_folded.setdefault(name.casefold(), name)
    if word.casefold() in by_folded:  # it differs in upper and lower case, or is known elsewhere
        return f"; did you mean {by_folded[word.casefold()]!r}?"
    for folded, name in by_folded.items():
        if folded.startswith(f"{word.casefold()}_"):  # the unit was forgotten
            return f"; did you mean {name!r}?"
    found = nearest_name(word.casefold(), by_folded, likeness)
    return "" if found is None else f"; did you mean {by_folded[found]!r}?"


def in_plain_letters(name: str) -> str:
    """Return a name as it is compared where case, and a stroke for a blank, make no difference."""
    return name.casefold().replace("_", " ").replace("-", " ")


def _is_contrary(written: set[str], name: str, may_turn: list[frozenset[str]]) -> bool:
    meant = set(name.casefold().split("_"))
    return any(meant & words and not written & meant & words for words in may_turn)


def known_text(names: Iterable[str], noun: str) -> str:
    """Return what there is instead, for the end of a sentence."""
    known = list(names)
    if not known:
        return f"; this scenario has no {noun}"
    return f"; there is only {known[0]}" if len(known) == 1 else f"; there are {listing(known)}"


def cut(text: str) -> str:
    """Return a name or text without what nobody would read of it; one without a letter in quotes."""
    if not text.strip():
        return "''"
    return text if len(text) <= _LONGEST else f"{text[: _LONGEST - 4]}…"


def listing(names: Iterable[str], most: int = 12) -> str:
    """Return names as a list for a sentence: sorted by the caller, cut after ``most``."""
    known = list(names)
    more = f", … ({len(known)} in all)" if len(known) > most else ""
    return ", ".join(known[:most]) + more
