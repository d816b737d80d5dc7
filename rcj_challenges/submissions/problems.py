"""Problems of a submission, as plain data: the code that opens it decides what to do about them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

from rcj_challenges.core.sanitize import sanitize

Level = Literal["passed", "warning", "failure"]

MAX_OF_A_KIND = 10
"""Of one kind of trouble so many are listed one by one; the rest is counted."""

MAX_PATH_SHOWN = 1000
"""The path that was given on the command line is shown as it was given, unless it is absurd."""

_MAX_LETTERS = 120


@dataclass(frozen=True)
class Problem:
    """One odd thing.

    Attributes:
        code: what it is, the same in every language and version: ``archive.encrypted``.
        level: ``failure``: the submission is not used; ``warning``: it is, but something was guessed or left out;
            ``passed``: worth mentioning, but harmless.
        message: what was found, one line, safe to show.
        help: what to do; empty if there is nothing to do.
        where: the file inside the submission; safe to show.
        repair: whether a repair puts it right.
    """

    code: str
    level: Level
    message: str
    help: str = ""
    where: str = ""
    repair: bool = False

    def __str__(self) -> str:
        """Return message and help as one sentence."""
        return with_help(self.message, self.help)


@dataclass
class Problems:
    """A list of troubles that stays short, however many there are."""

    _found: list[Problem] = field(default_factory=list)
    _count: Counter[str] = field(default_factory=Counter)

    def add(self, trouble: Problem) -> None:
        """Note one."""
        self._count[trouble.code] += 1
        if self._count[trouble.code] <= MAX_OF_A_KIND:
            self._found.append(trouble)

    def __iter__(self) -> Iterator[Problem]:
        yield from self._found
        for code, count in self._count.items():
            if count > MAX_OF_A_KIND:
                first = next(trouble for trouble in self._found if trouble.code == code)
                more = f"and {count - MAX_OF_A_KIND} more of this kind ({code})"
                yield Problem(code, first.level, more, first.help, repair=first.repair)


def with_help(message: str, help_: str) -> str:
    """Return what was found and what to do as one sentence."""
    return f"{message}{'' if message.endswith('?') else ':'} {help_}" if help_ else message


def safe_text(name: object, longest: int = _MAX_LETTERS) -> str:
    """Return a strange name as one harmless line, shorter than `sanitize` makes it: several stand in one message."""
    return sanitize(str(name) if isinstance(name, Path) else name, longest)
