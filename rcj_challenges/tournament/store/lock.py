"""One writer at a time: a lock that ends with the process that holds it."""

from __future__ import annotations

import os
from contextlib import suppress
from pathlib import Path

from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError
from rcj_challenges.core.files import try_lock
from rcj_challenges.tournament.codes import STORE_IN_USE

_LOCK_FILE = "store.lock"
_MAX_PID_BYTES = 32


class WriterLock:
    """Held by the one command that writes to a store."""

    def __init__(self, folder: Path) -> None:
        """Take the lock in the folder of the store.

        Raises:
            DiagnosticError: another command writes to this store.
            OSError: the file cannot be made.
        """
        path = folder / _LOCK_FILE
        self._fd = os.open(path, os.O_RDWR | os.O_CREAT, 0o644)
        try:
            is_held = not try_lock(self._fd)
        except OSError:  # a file system without locks: nothing can be proved
            is_held = False
        if is_held:
            pid = _pid_in(self._fd)
            self.close()
            raise _in_use(folder, pid)
        with suppress(OSError):  # for the message only
            os.ftruncate(self._fd, 0)
            os.write(self._fd, str(os.getpid()).encode())

    def close(self) -> None:
        """Give the lock back. Can be called again."""
        if self._fd >= 0:
            os.close(self._fd)
            self._fd = -1


def is_locked(folder: Path) -> bool:
    """Return whether a command writes to the store at present."""
    try:
        fd = os.open(folder / _LOCK_FILE, os.O_RDWR)
    except OSError:
        return False
    try:
        return not try_lock(fd)
    except OSError:
        return False
    finally:
        os.close(fd)


def _pid_in(fd: int) -> str:
    with suppress(OSError):
        return os.read(fd, _MAX_PID_BYTES).decode("ascii", "replace")
    return ""


def _in_use(folder: Path, pid: str) -> DiagnosticError:
    process = f" (process {pid})" if pid.isdecimal() else ""
    message = f"another command{process} is writing to the tournament's data in {folder}"
    help_ = "wait until it has ended, or end it; 'status' and 'results' can be used meanwhile"
    return DiagnosticError(Diagnostic(STORE_IN_USE, message, help_))
