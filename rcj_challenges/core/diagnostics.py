"""Errors with a code: what is wrong, where, and what to do about it, as text and as data.

All new errors have this form::

    error[unknown-zone]: unknown zone 'blue_gaol'
      --> challenge.yaml:41:18  rules.goal_in_blue.triggers[0].zone
    help: did you mean 'blue_goal'?
"""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any

from rcj_challenges.core.code import Code, Level
from rcj_challenges.core.errors import RcjError
from rcj_challenges.core.sanitize import sanitize

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
class InTree(InFile):
    """A place in a tree of values whose position in the file has not been looked up.

    Attributes:
        keys: keys and indices that lead there.
        at_key: whether the key is meant, not its value.
        other: another place that has part in it: reported there if only that one stands in the author's own file.
    """

    file: str = ""
    keys: tuple[str | int, ...] = ()
    at_key: bool = False
    other: tuple[str | int, ...] = ()


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
    """One thing that is wrong, or worth mentioning.

    Attributes:
        code: what it is; its page is printed by ``explain``.
        message: what is wrong, in one line.
        help: what to do about it, in one line; empty if there is nothing to do.
        where: the place: in a file, in a match, or the file or the robots of a submission as text; empty if there is
            none.
        level: how serious it is; that of the code, unless it is given.
        repair: whether ``check --fix`` repairs it; as of the code, unless it is given.
        details: more lines, such as a traceback; usually empty.
    """

    code: Code
    message: str
    help: str = ""
    where: InFile | InMatch | str = ""
    level: Level = None  # type: ignore[assignment]  # until it is made
    repair: bool = None  # type: ignore[assignment]  # until it is made
    details: str = ""

    def __post_init__(self) -> None:
        """Take from the code what was not given."""
        if self.level is None:
            object.__setattr__(self, "level", self.code.level)
        if self.repair is None:
            object.__setattr__(self, "repair", self.code.repair != "no")

    def __str__(self) -> str:
        lines = [f"{self.level}[{self.code}]: {sanitize(self.message, _MAX_CHARACTERS)}"]
        if self.where:
            lines.append(f"  --> {sanitize(self.where, _MAX_CHARACTERS)}")
        if self.help:
            lines.append(f"help: {sanitize(self.help, _MAX_CHARACTERS)}")
        return "\n".join(lines)

    @property
    def sentence(self) -> str:
        """Message and help in one line."""
        return f"{self.message}{'' if self.message.endswith('?') else ':'} {self.help}" if self.help else self.message

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


def issue(
    code: Code,
    keys: tuple[str | int, ...],
    message: str,
    help_: str = "",
    at_key: bool = False,
    other: tuple[str | int, ...] = (),
) -> Diagnostic:
    """A diagnostic at a place of a tree; arguments as of `Diagnostic` and `InTree`."""
    return Diagnostic(code, message, help_, InTree(keys=keys, at_key=at_key, other=other))
