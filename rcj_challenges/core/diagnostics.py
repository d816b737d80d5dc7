"""Errors with a code: what is wrong, where, and what to do about it, as text and as data.

All new errors have this form::

    error[unknown-zone]: unknown zone 'blue_gaol'
      --> challenge.yaml:41:18  rules.goal_in_blue.triggers[0].zone
    help: did you mean 'blue_goal'?
"""

from __future__ import annotations

import re
from dataclasses import asdict, dataclass
from typing import Any, Literal

from rcj_challenges.core.errors import RcjError
from rcj_challenges.core.sanitize import sanitize

_CODE = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*|[a-z]+[.][a-z0-9_]+")
_MAX_CHARACTERS = 1000
_MAX_PRINTED = 100


@dataclass(frozen=True)
class InFile:
    """A place in a file.

    Attributes:
        file: as the reader knows it: the path as given, or ``--set a=1``.
        line: from 1; None for the file as a whole.
        column: from 1; None for the line as a whole.
        path: keys and indices that lead there: ``rules.goal.triggers[0].zone``.
    """

    file: str
    line: int | None = None
    column: int | None = None
    path: str = ""

    def __str__(self) -> str:
        numbers = [str(number) for number in (self.line, self.column) if number is not None]
        return "  ".join(part for part in (":".join([self.file, *numbers]), self.path) if part)


@dataclass(frozen=True)
class InMatch:
    """A moment of a match.

    Attributes:
        robot: its name; empty if the whole match is concerned.
        tick: of the half; None if it had not begun.
        half: from 1; None if there is only one.
    """

    robot: str = ""
    tick: int | None = None
    half: int | None = None

    def __str__(self) -> str:
        parts = (
            f"robot {self.robot}" if self.robot else "",
            f"half {self.half}" if self.half is not None else "",
            f"tick {self.tick}" if self.tick is not None else "",
        )
        return ", ".join(part for part in parts if part)


@dataclass(frozen=True)
class Diagnostic:
    """One thing that is wrong.

    Attributes:
        code: stable over versions, lower case with hyphens: ``unknown-zone``; findings of ``check`` have the form
            ``stage.kind_of_it``.
        message: what is wrong, in one line.
        help: what to do about it, in one line; empty if there is nothing to say.
        where: the place; None if there is none.
        severity: whether it stops the command.
    """

    code: str
    message: str
    help: str = ""
    where: InFile | InMatch | None = None
    severity: Literal["error", "warning"] = "error"

    def __post_init__(self) -> None:
        """Refuse a code of another form.

        Raises:
            ValueError: the code has another form.
        """
        if not _CODE.fullmatch(self.code):
            raise ValueError(f"not a code: {self.code!r}")

    def __str__(self) -> str:
        lines = [f"{self.severity}[{self.code}]: {sanitize(self.message, _MAX_CHARACTERS)}"]
        if self.where is not None:
            lines.append(f"  --> {sanitize(self.where, _MAX_CHARACTERS)}")
        if self.help:
            lines.append(f"help: {sanitize(self.help, _MAX_CHARACTERS)}")
        return "\n".join(lines)

    def to_json(self) -> dict[str, Any]:
        """Return the fields as JSON-able data."""
        return asdict(self)


def render_error(error: RcjError) -> str:
    """Return an error as it is printed: code and help stand in it."""
    if isinstance(error, DiagnosticError) or not error.code:
        return str(error)
    message, *rest = str(error).split("\n")
    return "\n".join([str(Diagnostic(error.code, message, error.help)), *rest])


def one_line(error: RcjError) -> str:
    """Return message and help of an error in one line, for a report that has codes of its own."""
    found = error.diagnostics if isinstance(error, DiagnosticError) else (error,)
    return "; ".join(part for one in found for part in (_message_of(one), one.help) if part)


def _message_of(error: RcjError | Diagnostic) -> str:
    return error.message if isinstance(error, Diagnostic) else " ".join(str(error).split("\n"))


class DiagnosticError(RcjError):
    """Wrong input that has codes; all that is wrong is reported at once. ``str()`` is the text for the terminal."""

    def __init__(self, *diagnostics: Diagnostic) -> None:
        self.diagnostics = diagnostics
        more = len(diagnostics) - _MAX_PRINTED
        texts = [*map(str, diagnostics[:_MAX_PRINTED]), *([f"… and {more} more"] if more > 0 else [])]
        first = diagnostics[0]
        super().__init__("\n\n".join(texts), first.help, code=first.code)
