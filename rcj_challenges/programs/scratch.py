"""A program's private folder: its size, and its removal.

The program may change it at any time, even during an inspection. So nothing here follows links, recurses to an
unlimited depth, or trusts that a listed file still exists.
"""

from __future__ import annotations

import contextlib
import math
import os
import shutil
import stat
import sys
import tempfile
from pathlib import Path

_ENTRY_BYTES = 4096
"""What an entry counts at least: files cost a block and an inode even when they are empty."""

_LONGEST_PATH = 512
"""Characters of a path below the private folder. No honest program needs more, and soon no system call accepts more."""

_ROOM_BYTES = 1_000_000
"""More than a program writes at once, than a page of some teams needs, and a replay of ten seconds."""

_BLOCK_BYTES = 512
"""Unit of ``st_blocks``. A deleted folder has size 0, but keeps the blocks of all names that were in it."""

_DELETED = b" (deleted)"
"""How Linux marks a file mapped into a process's memory that has been deleted."""

_OF_FILES = 0.9
"""Part of a disk that files take, as they are counted here: the rest is lists of them and halves of blocks."""


def ensure_room(folder: Path) -> None:
    """Find out whether files can be written into a folder; nothing of it stays.

    Raises:
        OSError: they cannot, or there is no room for them.
    """
    with tempfile.TemporaryFile(dir=folder, prefix=".rcj-room-") as file:
        file.write(bytes(_ROOM_BYTES))
        file.flush()


def share_bytes(folder: Path, sharers: int) -> float:
    """Return the share of each of several in what a folder's disk still takes; infinite if it is full already.

    When it is full (`ensure_room`) and only they have written, at least one of them has written more than this.
    """
    free_bytes = shutil.disk_usage(folder).free
    if free_bytes < 2 * _ROOM_BYTES:
        return math.inf
    return _OF_FILES * (free_bytes - _ROOM_BYTES) / max(1, sharers)


def has_more_than(folder: Path, limit_bytes: float) -> bool:
    """Return whether all files below a folder take more than a limit, or something in it cannot be looked at."""
    return bytes_below(folder, limit_bytes) > limit_bytes


def bytes_below(folder: Path, enough_bytes: float) -> float:
    """Return the size of all files below a folder; infinite if something in it cannot be looked at.

    The folder may change meanwhile. Counting ends where there are more than ``enough_bytes``.
    """
    total = 0
    longest = len(str(folder)) + _LONGEST_PATH
    todo = [str(folder)]
    if _leads_elsewhere(folder):
        return math.inf
    while todo:
        here = todo.pop()
        if len(here) > longest:
            return math.inf
        try:
            with os.scandir(here) as entries:
                for entry in entries:
                    if is_folder(entry):
                        todo.append(entry.path)
                    total += _entry_bytes(entry)
                    if total > enough_bytes:
                        return total
        except PermissionError:
            return math.inf  # a folder that its owner may not read hides something
        except OSError:
            continue
    return total


def _entry_bytes(entry: os.DirEntry[str]) -> int:
    # What is gone by now counts too: a folder whose files come and go all the time could be listed without end.
    with contextlib.suppress(OSError):
        return max(entry.stat(follow_symlinks=False).st_size, _ENTRY_BYTES)
    return _ENTRY_BYTES


def nameless_bytes(pid: int, output_fd: int, folder: Path, *, in_memory: bool = True) -> float:
    """Return the size of a process's open files and folders that have no name any more (Linux; elsewhere 0).

    Its threads must share one table of open files, which the layer ``system_calls`` enforces. The file of its output,
    open here as ``output_fd``, is counted elsewhere.

    Infinite if there is one of its private folder that is only mapped into its memory, because its size is unknown; to
    look for these too takes longer than all the rest.
    """
    total = 0
    if sys.platform == "linux":
        known = {_identity(os.fstat(output_fd))} if output_fd >= 0 else set()
        with contextlib.suppress(OSError), os.scandir(f"/proc/{pid}/fd") as descriptors:
            for descriptor in descriptors:
                with contextlib.suppress(OSError):
                    status = os.stat(descriptor.path)  # noqa: PTH116 - a number, not a path of ours
                    if not status.st_nlink and _identity(status) not in known:
                        known.add(_identity(status))
                        is_file = stat.S_ISREG(status.st_mode)
                        total += status.st_size if is_file else _BLOCK_BYTES * status.st_blocks
        if in_memory and _maps_another(pid, folder, {inode for _, inode in known}):
            return math.inf
    return total


def _maps_another(pid: int, folder: Path, known: set[int]) -> bool:
    """Return whether a process has a file in its memory that was in a folder and is deleted, beside known inodes."""
    below = os.fsencode(f"{folder}{os.sep}")
    try:
        with open(f"/proc/{pid}/maps", "rb", buffering=0) as file:  # noqa: PTH123 - no path of ours
            maps = file.read()
    except OSError:
        return False
    if below not in maps:
        return False
    # Addresses, rights, offset, device, inode, path.
    mapped = [line.split(maxsplit=5) for line in maps.split(b"\n") if line.endswith(_DELETED) and below in line]
    return any(fields[5].startswith(below) and int(fields[4]) not in known for fields in mapped)


def _identity(status: os.stat_result) -> tuple[int, int]:
    return status.st_dev, status.st_ino


def remove(folder: Path) -> None:
    """Remove a folder with all that is in it, whatever a program did to it. Its processes must have ended."""
    if _leads_elsewhere(folder):
        with contextlib.suppress(OSError):
            folder.unlink()
        return
    emptied: list[str] = []
    todo = [str(folder)]
    longest = len(str(folder)) + _LONGEST_PATH
    while todo:
        here = todo.pop()
        if len(here) > longest:
            here = _brought_up(here, f"{folder}{os.sep}{os.urandom(8).hex()}")
        emptied.append(here)
        with contextlib.suppress(OSError):
            os.chmod(here, 0o700)  # noqa: PTH101 - paths are text here: there may be very many
            with os.scandir(here) as entries:
                listed = list(entries)
            for entry in listed:
                if is_folder(entry):
                    todo.append(entry.path)
                else:
                    _unlink(entry.path)
    # A folder comes after the one that it is in, and one that was brought up after the topmost.
    for path in reversed(emptied):
        with contextlib.suppress(OSError):
            os.rmdir(path)  # noqa: PTH106


def _brought_up(path: str, place: str) -> str:
    with contextlib.suppress(OSError):
        os.chmod(path, 0o700)  # noqa: PTH101
        os.rename(path, place)  # noqa: PTH104
        return place
    return path


def _leads_elsewhere(folder: Path) -> bool:
    if sys.platform == "win32":
        with contextlib.suppress(OSError):
            return folder.lstat().st_reparse_tag in (stat.IO_REPARSE_TAG_SYMLINK, stat.IO_REPARSE_TAG_MOUNT_POINT)
    return os.path.islink(folder)  # noqa: PTH114 - a match waits


def is_folder(entry: os.DirEntry[str]) -> bool:
    """Return whether it is a folder itself, and neither a link to one nor a junction (Windows)."""
    if not entry.is_dir(follow_symlinks=False):
        return False
    return sys.platform != "win32" or entry.stat().st_reparse_tag != stat.IO_REPARSE_TAG_MOUNT_POINT


def _unlink(path: str) -> None:
    with contextlib.suppress(OSError):
        if sys.platform == "win32" and not os.path.islink(path):  # noqa: PTH114
            os.chmod(path, 0o600)  # noqa: PTH101 - Windows deletes no read-only file
        os.unlink(path)  # noqa: PTH108
