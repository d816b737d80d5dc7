"""Files: names that are valid on every computer, opening without waiting, locks that end with their process."""

from __future__ import annotations

import errno
import hashlib
import os
import re
import stat
import sys
from pathlib import Path
from typing import BinaryIO

from rcj_challenges.core.errors import taken, unwritable

_DEVICES = re.compile(r"con|prn|aux|nul|conin\$|conout\$|(com|lpt)[0-9¹²³]", re.IGNORECASE)
_INVALID = re.compile(r"[^A-Za-z0-9_.-]")
_MAX_SLUG = 120
_INDEX = "index"
"""The page of a folder of pages: no file that is named after something else takes its name."""


def is_device_of_windows(name: str) -> bool:
    """Return whether Windows reserves this name, whatever its ending."""
    return _DEVICES.fullmatch(name.partition(".")[0].rstrip()) is not None


def slug(identifier: str) -> str:
    """Return an id as the name of a file without its ending: ``groups.A.round2.ada-bee``.

    Two ids that differ by more than case never share one.
    """
    name = identifier.replace("/", ".")
    is_free = name.casefold() != _INDEX and not is_device_of_windows(name)
    if is_free and len(name) <= _MAX_SLUG and not _INVALID.search(name):
        return name
    digest = hashlib.sha256(identifier.encode()).hexdigest()[:16]
    return f"{'' if is_free else '_'}{_INVALID.sub('_', name)[:_MAX_SLUG]}.{digest}"


def open_without_waiting(path: Path) -> BinaryIO:
    """Open a file for reading without waiting for the other end of a pipe."""
    # Windows has no pipes among its files.
    return open(path, "rb", opener=lambda name, flags: os.open(name, flags | getattr(os, "O_NONBLOCK", 0)))


def open_regular(path: Path) -> BinaryIO:
    """Open a regular file for reading.

    Raises:
        OSError: it is a pipe or a device, or cannot be opened.
    """
    file = open_without_waiting(path)
    if stat.S_ISREG(os.fstat(file.fileno()).st_mode):
        return file
    file.close()
    raise OSError(errno.EINVAL, "it is a pipe or a device, not a file", str(path))


def write_new(path: Path, content: bytes) -> None:
    """Write a file that is not there yet, and its folders; nothing is left of one that cannot be written whole.

    Raises:
        RcjError: there is something of that name, or it cannot be written.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        file = path.open("xb")
        try:
            with file:
                file.write(content)
        except BaseException:  # an interruption too: half of it would be in the way of the next attempt
            path.unlink(missing_ok=True)
            raise
    except FileExistsError:
        raise taken(path) from None
    except OSError as error:
        raise unwritable(path, error) from error


if sys.platform == "win32":
    import msvcrt
else:
    import fcntl


def try_lock(fd: int) -> bool:
    """Lock a file until it is closed; return False if another process, or another opening in this one, holds it.

    Raises:
        OSError: there are no locks in this file system.
    """
    if sys.platform == "win32":
        try:
            msvcrt.locking(fd, msvcrt.LK_NBLCK, 1)
        except OSError:
            return False
        return True
    try:
        fcntl.flock(fd, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return False
    return True
