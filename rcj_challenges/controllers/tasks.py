"""How many threads there are (Linux): of one process, and of all processes of a user."""

from __future__ import annotations

import contextlib
import functools
import os

_LINKS_OF_A_FOLDER = 2  # itself and its parent; each further one is a folder in it, here a thread


def threads_of(pid: int) -> int:
    """Return how many threads a process has; 0 where that cannot be told, or if there is no such process."""
    try:
        return max(0, os.stat(f"/proc/{pid}/task").st_nlink - _LINKS_OF_A_FOLDER)  # noqa: PTH116 - called while a match waits
    except OSError:
        return 0


@functools.cache
def tasks_of_user() -> int:
    """Return how many threads all processes of this process's user had when this was first asked; 0: not known.

    ``RLIMIT_NPROC`` counts all of them together, so a limit for one program can only be one above what there is.
    """
    user, total = os.geteuid(), 0
    with contextlib.suppress(OSError):
        for entry in os.scandir("/proc"):
            with contextlib.suppress(OSError):
                if entry.name.isdigit() and entry.stat().st_uid == user:
                    total += threads_of(int(entry.name))
    return total
