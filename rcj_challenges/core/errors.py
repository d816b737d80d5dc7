"""The base of all errors that mean *wrong input*: shown as one message without a traceback, exit code 2."""

from __future__ import annotations

import errno
from typing import ClassVar

from rcj_challenges.core.code import Code
from rcj_challenges.core.codes import CANNOT_WRITE, FILE_EXISTS, HOST_ERROR
from rcj_challenges.core.sanitize import sanitize


class RcjError(Exception):
    """Wrong input; the message says what is wrong, where, and what would be right.

    Attributes:
        exit_code: what the command line exits with.
        code: as of a `Diagnostic`; None if the message is printed as it is.
        help: what to do about it, in one line; may be empty.
    """

    exit_code: ClassVar[int] = 2
    CODE: ClassVar[Code | None] = None
    """Of errors that are raised without one."""

    def __init__(self, message: object = "", help_: str = "", *, code: Code | None = None) -> None:
        super().__init__(message)
        self.code = code or self.CODE
        self.help = help_


class HostError(RcjError):
    """A failure of this computer: no space, too many open files. Neither a program nor a team is to blame."""

    CODE = HOST_ERROR


_OF_THE_HOST = frozenset(
    getattr(errno, name)
    for name in ("EAGAIN", "EDQUOT", "EFBIG", "EIO", "EMFILE", "ENFILE", "ENOMEM", "ENOSPC", "EROFS")
    if hasattr(errno, name)  # Windows has no quotas
)
_OF_THE_HOST_ON_WINDOWS = frozenset({14, 39, 1450, 1455})
"""Those of Windows (``winerror``) that ``errno`` reports as EINVAL: no memory, a full disk, no system resources, and a
paging file that is too small."""


def is_of_the_host(error: BaseException) -> bool:
    """Return whether an error is about this computer's own limits."""
    if not isinstance(error, OSError):
        return False
    return error.errno in _OF_THE_HOST or getattr(error, "winerror", None) in _OF_THE_HOST_ON_WINDOWS


_HELD = frozenset({5, 32})
"""Error codes of Windows (``winerror``) if another program has a file open: access denied, sharing violation."""


def is_held(error: OSError) -> bool:
    """Return whether an error may mean that another program has the file open, which happens only on Windows."""
    return getattr(error, "winerror", None) in _HELD


def format_error(error: BaseException) -> str:
    """Format an error; errors of the system come without paths, because records are published."""
    return (error.strerror if isinstance(error, OSError) else None) or str(error)


_NO_ROOM = frozenset(getattr(errno, name) for name in ("ENOSPC", "EDQUOT") if hasattr(errno, name))


def is_no_room(error: BaseException) -> bool:
    """Return whether an error says that a disk is full, or this user's share of it."""
    return isinstance(error, OSError) and error.errno in _NO_ROOM


def error_hint(error: BaseException) -> str:
    """Format the system's error about a file that cannot be written, with help if the disk is full."""
    return format_error(error) + ("; make room there, or write it elsewhere" if is_no_room(error) else "")


def room_help(error: BaseException) -> str:
    """Return help for something that could not be written; empty unless the disk is full."""
    return "make room there, or write it elsewhere" if is_no_room(error) else ""


def unwritable(path: object, error: BaseException) -> RcjError:
    """Return the error about a file that cannot be written, with help if the disk is full."""
    return RcjError(f"{sanitize(path)}: cannot be written: {format_error(error)}", room_help(error), code=CANNOT_WRITE)


def taken(path: object) -> RcjError:
    """Return the error about a file that would have to be overwritten."""
    message = f"{sanitize(path)} exists already; nothing was written"
    return RcjError(message, "choose another name, or move it away", code=FILE_EXISTS)


def interruption_behind(error: BaseException | None) -> KeyboardInterrupt | None:
    """Return the interruption behind an error: in the middle of an import one comes out as an error of the import."""
    while error is not None and not isinstance(error, KeyboardInterrupt):
        error = error.__context__
    return error
