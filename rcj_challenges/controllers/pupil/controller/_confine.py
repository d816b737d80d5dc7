"""Limits that a program's process sets itself before any of the program's code runs.

Which of them apply is the parent's decision (``rcj_challenges/controllers/isolation.py``); here is only how. Further
layers (Landlock, seccomp) belong here as further entries of ``LAYERS``.
"""

# ruff: noqa: PLC0415 - each import costs every program, so there are few, and only where they are needed

from __future__ import annotations

import os
import sys
from _thread import start_new_thread
from collections.abc import Callable
from typing import Any

from ._wire import leave

_PR_SET_PDEATHSIG = 1  # linux/prctl.h
_PR_SET_NO_NEW_PRIVS = 38
_SIGKILL = 9


class ConfinementError(OSError):
    """A layer that the match counts on could not be put in place."""


def limit_resources(settings: dict[str, Any]) -> None:
    """Limit memory, file sizes and open files; no core dumps. POSIX only."""
    import resource

    wanted = {
        "RLIMIT_AS": settings["memory_bytes"],
        "RLIMIT_FSIZE": settings["file_bytes"],
        "RLIMIT_NOFILE": settings["open_files"],
        "RLIMIT_CORE": 0,
    }
    if settings["watch_memory"]:
        del wanted["RLIMIT_AS"]  # macOS takes no limit on the address space
    for name, value in wanted.items():
        kind = getattr(resource, name)
        _, hard = resource.getrlimit(kind)
        capped = value if hard == resource.RLIM_INFINITY else min(value, hard)
        resource.setrlimit(kind, (capped, capped))


def refuse_new_privileges(settings: dict[str, Any]) -> None:  # noqa: ARG001 - all layers are called alike
    """Make setuid programs start without their privileges. Linux only."""
    _prctl(_PR_SET_NO_NEW_PRIVS, 1)


def end_with_parent(settings: dict[str, Any]) -> None:
    """Let the kernel end this process when the match's process ends, however that ends. Linux only."""
    _prctl(_PR_SET_PDEATHSIG, _SIGKILL)
    if os.getppid() != settings["parent"]:
        leave(1)


LAYERS: dict[str, Callable[[dict[str, Any]], None]] = {
    "ends_with_parent": end_with_parent,
    "resource_limits": limit_resources,
    "no_new_privileges": refuse_new_privileges,
}


def confine(layers: list[str], settings: dict[str, Any]) -> None:
    """Put the layers in place that this process has to set itself.

    Raises:
        OSError: one could not be.
    """
    for name, layer in LAYERS.items():
        if name in layers:
            try:
                layer(settings)
            except (OSError, ValueError) as error:
                raise ConfinementError(f"{name}: {error}") from error


def watch(lifeline_fd: int, memory_bytes: int, on_memory: Callable[[], None]) -> None:
    """Watch from a thread, where the kernel does not: end with the parent, report too much memory (macOS).

    Args:
        lifeline_fd: read end of a pipe that ends when the parent does.
        memory_bytes: the limit; 0: somebody else watches it.
        on_memory: called when it is exceeded.
    """

    def guard() -> None:
        while memory_bytes and not _readable(lifeline_fd, 0.25):
            if _resident_bytes() > memory_bytes:
                on_memory()
        try:
            os.read(lifeline_fd, 1)
        finally:
            leave(1)

    start_new_thread(guard, ())


def _readable(fd: int, seconds: float) -> bool:
    import select

    return bool(select.select([fd], [], [], seconds)[0])


def _resident_bytes() -> int:
    import resource

    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak if sys.platform == "darwin" else peak * 1024


def _prctl(option: int, value: int) -> None:
    import ctypes

    libc = ctypes.CDLL(None, use_errno=True)
    if libc.prctl(option, value, 0, 0, 0) != 0:
        errno = ctypes.get_errno()
        raise OSError(errno, os.strerror(errno))
