"""Reading files that strangers name: a named pipe would block for ever, a device might never end."""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path
from typing import BinaryIO


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
