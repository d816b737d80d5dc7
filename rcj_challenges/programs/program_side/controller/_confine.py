"""Limits that a program's process sets itself before any of the program's code runs.

The parent decides which of them apply (``rcj_challenges/programs/isolation.py``); this module sets them.
"""

# ruff: noqa: PLC0415 - each import costs every program, so there are few, and only where they are needed

from __future__ import annotations

import faulthandler
import os
import sys
import time
from _thread import allocate_lock, start_new_thread

from ._wire import leave

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

_real_sleep = time.sleep  # that of programs follows the match
_SIGKILL = 9
_UNTIL_PARENT_ACTS_S = 2.0
_SIGNAL_SLOTS = 64  # for timers and queued signals; the kernel counts those of all processes of the user
_DUMP_BEGINS = b"Fatal Python error: Aborted\n\n"  # as where a signal asks for it


class ConfinementError(OSError):
    """A layer that the match counts on could not be put in place."""


def limit_resources(settings: dict[str, Any]) -> None:
    """Limit memory, processor time, file sizes, open files, threads and signal slots; no core dumps. POSIX only."""
    import resource

    wanted = {
        "RLIMIT_AS": settings["memory_bytes"],
        "RLIMIT_CPU": settings["processor_s"],
        "RLIMIT_FSIZE": settings["file_bytes"],
        "RLIMIT_NOFILE": settings["open_files"],
        "RLIMIT_CORE": 0,
    }
    if settings["user_tasks"]:
        wanted["RLIMIT_NPROC"] = settings["user_tasks"]
    if sys.platform == "linux":
        wanted["RLIMIT_SIGPENDING"] = _SIGNAL_SLOTS
    if settings["watch_memory"]:
        del wanted["RLIMIT_AS"]  # macOS takes no limit on the address space
    for name, value in wanted.items():
        kind = getattr(resource, name)
        _, hard = resource.getrlimit(kind)
        capped = value if hard == resource.RLIM_INFINITY else min(value, hard)
        # At the first of two seconds of processor time comes a signal that says so, at the second the one that kills.
        after = 1 if name == "RLIMIT_CPU" and capped != hard else 0
        resource.setrlimit(kind, (capped, capped + after))


def give_up_privileges(settings: dict[str, Any]) -> None:  # noqa: ARG001 - all layers are called alike
    """Give up what root may do, and make setuid programs start without their privileges. Linux only."""
    from . import _native

    _native.drop_capabilities()
    _native.refuse_new_privileges()


def end_with_parent(settings: dict[str, Any]) -> None:
    """Let the kernel end this process when the match's process ends, however that ends. Linux only."""
    from . import _native

    _native.process_control(_native.PR_SET_PDEATHSIG, _SIGKILL)
    if os.getppid() != settings["parent"]:
        leave(1)


def restrict_files(settings: dict[str, Any]) -> None:
    """Hide all files but those that the parent names. Linux only."""
    from . import _landlock

    _landlock.restrict_files(settings)


def restrict_calls(settings: dict[str, Any]) -> None:
    """Refuse the system calls that no program needs. Linux only."""
    from . import _seccomp

    _seccomp.restrict_calls(settings)


def forget_bubblewrap(settings: dict[str, Any]) -> None:  # noqa: ARG001 - all layers are called alike
    """Remove what bubblewrap put into the environment: a program is to see the same with it and without. Linux only."""
    os.environ.pop("PWD", None)


LAYERS: dict[str, Callable[[dict[str, Any]], None]] = {
    "ends_with_parent": end_with_parent,
    "bubblewrap": forget_bubblewrap,
    "resource_limits": limit_resources,
    "no_new_privileges": give_up_privileges,
    "filesystem": restrict_files,
    # Last: it refuses what the others are made with.
    "system_calls": restrict_calls,
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

    The pipe of ``lifeline_fd`` ends when the parent does; a byte in it asks for a traceback, and the end.
    ``memory_bytes`` of 0: memory is limited elsewhere.
    """
    is_too_much = _memory_watch(lifeline_fd, memory_bytes) if memory_bytes else None

    def guard() -> None:
        begun.release()
        try:
            while is_too_much is not None and (too_much := is_too_much()) is not None:
                if too_much:
                    on_memory()
            if os.read(lifeline_fd, 1):
                os.write(2, _DUMP_BEGINS)
                faulthandler.dump_traceback(2, all_threads=True)
        except (OSError, ValueError):
            # The program has closed a descriptor that is not its own. The parent notices that first and reports it.
            _real_sleep(_UNTIL_PARENT_ACTS_S)
        finally:
            leave(1)

    begun = allocate_lock()
    begun.acquire()
    start_new_thread(guard, ())
    # From now on the match counts it, and does not take it for one of the program's threads.
    with begun:
        pass


def _memory_watch(fd: int, limit_bytes: int) -> Callable[[], bool | None]:
    """Return a function that waits a moment and returns whether memory is over the limit; None: ``fd`` is readable."""
    import resource
    import select

    # A team may have files of these names, which it then imports; its waits follow match time, this one does not.
    for name in ("resource", "select"):
        sys.modules.pop(name, None)
    wait, usage, this_process = select.select, resource.getrusage, resource.RUSAGE_SELF
    unit_bytes = 1 if sys.platform == "darwin" else 1024

    def is_too_much() -> bool | None:
        if wait([fd], [], [], 0.25)[0]:
            return None
        return usage(this_process).ru_maxrss * unit_bytes > limit_bytes

    return is_too_much
