"""Creates the private folders of a half, and removes those that killed matches left behind.

A match or a check that is killed (``kill -9``, a power cut) cannot remove what it made. So all that it makes in the
temporary folder is in one folder with a file that it holds locked while it lives: the system gives the lock back
however a process ends. A match that starts removes such folders whose lock it gets. Neither clocks nor process ids
decide, and a lock that is held is never waited for.
"""

from __future__ import annotations

import contextlib
import functools
import os
import stat
import sys
import tempfile
from pathlib import Path
from typing import Self

from rcj_challenges.core.files import try_lock
from rcj_challenges.core.temporary_folder import temporary_folder_error
from rcj_challenges.programs import scratch

PREFIX = "rcj-match-"
LOCK_FILE = "in-use"

_ATTEMPTS = 100  # another match may take a folder for a left-over in the moment before it is locked
# What a program may have put in the place of the file is neither followed nor waited for.
_FLAGS = os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)


class PrivateFolders:
    """A place for the private folders of a half's programs, or for a check's files; only this user may look into it.

    A context manager.
    """

    def __init__(self) -> None:
        """Make the place, in the temporary folder.

        Raises:
            HostError: it cannot be made.
        """
        try:
            self.place, self._lock_fd = _made()
        except OSError as error:
            raise temporary_folder_error(error) from error

    def close(self) -> None:
        """Remove it with all that is in it. The programs must have ended. Can be called again."""
        if self._lock_fd >= 0:
            _discard(self.place, self._lock_fd)
            self._lock_fd = -1

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


@functools.cache
def remove_left_overs_once() -> None:
    """Remove the leftovers of dead matches from the temporary folder, at the first call in this process."""
    remove_left_overs(Path(tempfile.gettempdir()))


def remove_left_overs(temporary: Path) -> None:
    """Remove the places of dead matches from the temporary folder. Whatever cannot be removed stays."""
    with contextlib.suppress(OSError), os.scandir(temporary) as entries:
        for entry in entries:
            if entry.name.startswith(PREFIX):
                with contextlib.suppress(OSError):
                    _remove_if_unused(entry)


def _remove_if_unused(entry: os.DirEntry[str]) -> None:
    mine = sys.platform == "win32" or entry.stat(follow_symlinks=False).st_uid == os.geteuid()
    if not mine or not scratch.is_folder(entry):
        return
    folder = Path(entry.path)
    fd = os.open(folder / LOCK_FILE, _FLAGS, 0o600)
    try:
        is_unused = try_lock(fd) and _is_in_its_place(fd, folder)
    except OSError:  # no locks here: nothing can be proved
        is_unused = False
    if is_unused:
        _discard(folder, fd)
    else:
        os.close(fd)


def _made() -> tuple[Path, int]:
    for _ in range(_ATTEMPTS):
        folder = Path(tempfile.mkdtemp(prefix=PREFIX)).resolve()
        try:
            fd = os.open(folder / LOCK_FILE, _FLAGS, 0o600)
        except FileNotFoundError:
            continue  # somebody has just removed it
        except OSError:
            folder.rmdir()
            raise
        try:
            held = try_lock(fd)
        except OSError:
            held = True  # a file system without locks: other processes get none either
        if held and _is_in_its_place(fd, folder):
            return folder, fd
        os.close(fd)
    raise OSError(f"no folder in {tempfile.gettempdir()} stays where it was made")


def _discard(folder: Path, lock_fd: int) -> None:
    """Remove a folder; its lock is held until all else is gone."""
    scratch.remove(folder)
    os.close(lock_fd)
    if sys.platform == "win32":  # a file that is open stays
        with contextlib.suppress(OSError):
            (folder / LOCK_FILE).unlink()
            folder.rmdir()


def _is_in_its_place(fd: int, folder: Path) -> bool:
    """Return whether the file of a lock is an ordinary one, and still the one of that name."""
    try:
        found = (folder / LOCK_FILE).lstat()
    except OSError:
        return False
    return stat.S_ISREG(found.st_mode) and os.path.samestat(os.fstat(fd), found)
