"""What is wrong with a tournament file: a code, the place, and what to do about it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from rcj_challenges.facts.errors import RcjError
from rcj_challenges.scenario.tree import Mark

MAX_SHOWN = 100


@dataclass(frozen=True, slots=True)
class Problem:
    """One mistake.

    Attributes:
        code: names the kind of mistake, for good: ``unknown-key``.
        message: what is wrong.
        help: what to do; empty if the message says it.
        file: as the reader knows it.
        line, column: from 1; 0 if it is about no line.
        path: where in names: ``stages.groups.legs``.
    """

    code: str
    message: str
    help: str
    file: str
    line: int = 0
    column: int = 0
    path: str = ""

    def __str__(self) -> str:
        where = f"{self.file}:{self.line}:{self.column}" if self.line else self.file
        lines = [f"error[{self.code}]: {self.message}", f"  --> {where}  {self.path}".rstrip()]
        return "\n".join([*lines, f"help: {self.help}"] if self.help else lines)

    def to_json(self) -> dict[str, Any]:
        """Return it as data."""
        return {name: getattr(self, name) for name in ("code", "message", "help", "file", "line", "column", "path")}


def problem_at(mark: Mark, code: str, message: str, help_: str = "", path: str = "") -> Problem:
    """Return a problem at a place of a file."""
    return Problem(code, message, help_, mark.file, mark.line, mark.column, path)


class TournamentFileError(RcjError):
    """A tournament file cannot be used.

    Attributes:
        problems: all of them, by position.
    """

    def __init__(self, problems: Iterable[Problem]) -> None:
        self.problems = sorted(dict.fromkeys(problems), key=lambda one: (one.file, one.line, one.column, one.code))
        shown = [str(problem) for problem in self.problems[:MAX_SHOWN]]
        if len(self.problems) > MAX_SHOWN:
            shown.append(f"… and {len(self.problems) - MAX_SHOWN} more")
        super().__init__("\n".join(shown))
