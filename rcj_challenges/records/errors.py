"""Errors of records."""

from __future__ import annotations

import errno
from pathlib import Path
from typing import Self

from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.core.errors import HostError, format_error, is_held
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.records.codes import CANNOT_WRITE_RECORD, RECORD_DAMAGED


class RecordError(DiagnosticError):
    """A record that is missing, damaged, foreign, or of another version."""

    def __init__(self, code: Code, message: str, help_: str = "") -> None:
        super().__init__(Diagnostic(code, message, help_))

    @classmethod
    def damaged(cls, what: str) -> Self:
        """Return the error for a damaged file; ``what`` is the message, which begins with the record's folder."""
        return cls(RECORD_DAMAGED, what, COPY_AGAIN)

    @property
    def message(self) -> str:
        """What is wrong, for a sentence: without code and help."""
        return self.diagnostics[0].message


class UnwritableError(RecordError, HostError):
    """A record that cannot be written on this computer at present."""

    @classmethod
    def of(cls, error: OSError, place: Path) -> Self | None:
        """Translate an error about a file in the record's folder, or the one it is in; None for any other."""
        if not isinstance(error.filename, str) or not Path(error.filename).is_relative_to(place):
            return None
        help_ = _HELD_HELP if is_held(error) else _HELP.get(error.errno or 0, "")
        message = f"the record cannot be written: {sanitize(error.filename)}: {format_error(error)}"
        return cls(CANNOT_WRITE_RECORD, message, help_)


COPY_AGAIN = "copy the whole record again"

_HELD_HELP = "close the program that may have it open, or give a folder with --out in which you may write"
_HELP = {
    **dict.fromkeys(
        (getattr(errno, name) for name in ("ENOSPC", "EDQUOT", "EFBIG") if hasattr(errno, name)),
        "free some space there, or give another folder with --out",
    ),
    **dict.fromkeys((errno.EACCES, errno.EPERM, errno.EROFS), "give a folder with --out in which you may write"),
    errno.ENOENT: "it may have been moved or deleted: run the command again",
}
