"""Problems of a submission, as plain data: the code that opens it decides what to do about them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.core.sanitize import sanitize

MAX_OF_A_KIND = 10
"""Of one kind of problem so many are listed one by one; the rest is counted."""

MAX_PATH_SHOWN = 1000
"""The path that was given on the command line is shown as it was given, unless it is absurd."""

_MAX_CHARACTERS = 120


@dataclass
class Problems:
    """A list of problems that stays short, however many there are."""

    _found: list[Diagnostic] = field(default_factory=list)
    _count: Counter[Code] = field(default_factory=Counter)

    def add(self, problem: Diagnostic) -> None:
        """Note one."""
        self._count[problem.code] += 1
        if self._count[problem.code] <= MAX_OF_A_KIND:
            self._found.append(problem)

    def __iter__(self) -> Iterator[Diagnostic]:
        yield from self._found
        for code, count in self._count.items():
            if count > MAX_OF_A_KIND:
                first = next(problem for problem in self._found if problem.code == code)
                more = f"and {count - MAX_OF_A_KIND} more of this kind ({code})"
                yield Diagnostic(code, more, first.help, repair=first.repair, level=first.level)


def safe_text(name: object, longest: int = _MAX_CHARACTERS) -> str:
    """Return a strange name as one harmless line, shorter than `sanitize` makes it: several stand in one message."""
    return sanitize(str(name) if isinstance(name, Path) else name, longest)
