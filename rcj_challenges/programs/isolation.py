"""Isolation of a team's program from everything else: its layers, and how each is requested.

The only place that decides about isolation. A layer is either set by the parent when it starts the process (its
environment, folder, session) or by the process itself before the program's first line
(``program_side/controller/_confine.py``). Layers that a platform lacks are missing from `active_layers`, and records
say so.
"""

from __future__ import annotations

import functools
import math
import os
import sys
from pathlib import Path
from typing import Any

from rcj_challenges.core.errors import RcjError
from rcj_challenges.programs import bubblewrap, process_stats, processes, visible_files
from rcj_challenges.programs.codes import ISOLATION_MISSING, UNKNOWN_SANDBOX
from rcj_challenges.programs.program_side.controller import _landlock, _seccomp
from rcj_challenges.scenario.models.limits import Limits

SANDBOXES = ("auto", "strict", "off")

LAYERS: dict[str, str] = {
    "clean_environment": "none of the parent's environment variables",
    "private_folder": "a copy of the team's files as current directory, discarded afterwards",
    "ends_with_parent": "no process outlives the match, however the match ends",
    "resource_limits": "limited memory, processor time, file size, open files and threads",
    "no_new_privileges": "none of root's privileges, none by setuid programs",
    "filesystem": "no sight of files that are not the program's",
    "system_calls": "no network, no new processes, no tracing, no signals to others",
}
"""All layers of a strict run, and what each is for."""

EXTRA_LAYERS: dict[str, str] = {
    "bubblewrap": "no sight of names, processes and network outside either; where it is installed",
}
"""Layers that are added if available; no run requires them."""

_ALWAYS = ("clean_environment", "private_folder", "ends_with_parent")
_OPEN_FILES = 256
_CROWD = 16  # programs beside this one whose threads the limit for the whole user has to leave room for
_HALVES_OF_CPU_TIME = 2  # of ``half_s``: once in its steps, once beside them

_NOT_HERE = {
    "win32": "Windows has nothing that a program without installation could use",
    "darwin": "macOS has nothing that is documented and kept up",
}


def active_layers(sandbox: str, platform: str = sys.platform) -> tuple[str, ...]:
    """Return the layers that programs get on this platform.

    ``auto`` takes what there is, ``strict`` refuses to go without one, ``off`` takes only what keeps runs tidy.

    Raises:
        RcjError: ``strict``, and layers are missing; or no such sandbox.
    """
    if sandbox not in SANDBOXES:
        raise RcjError(f"unknown sandbox {sandbox!r}", f"write {', '.join(SANDBOXES)}", code=UNKNOWN_SANDBOX)
    if sandbox == "off":
        return _ALWAYS
    missing = missing_layers(platform)
    if sandbox == "strict" and (refused := missing | dropped_layers(sandbox, platform)):
        lacking = "; ".join(f"{layer} ({(LAYERS | EXTRA_LAYERS)[layer]}): {why}" for layer, why in refused.items())
        message = f"--sandbox strict: layers of isolation are missing here: {lacking}"
        help_ = "play with --sandbox auto, or on another computer (docs/isolation.md)"
        raise RcjError(message, help_, code=ISOLATION_MISSING)
    layers = tuple(layer for layer in LAYERS if layer not in missing)
    return (*layers, *EXTRA_LAYERS) if platform == "linux" and _has_bubblewrap() else layers


def missing_layers(platform: str = sys.platform) -> dict[str, str]:
    """Return the layers that a platform lacks, each with the reason, in the order of `LAYERS`."""
    if platform == "linux":
        return dict(_missing_on_linux())
    why = _NOT_HERE.get(platform, f"nothing is known of {platform}")
    return dict.fromkeys(("no_new_privileges", "filesystem", "system_calls"), why)


def dropped_layers(sandbox: str, platform: str = sys.platform) -> dict[str, str]:
    """Return the layers that programs should get on this platform and do not get on this computer, with the reasons."""
    if sandbox == "off" or platform != "linux":
        return {}
    dropped = missing_layers(platform)
    if visible_files.can_be_narrow() and (why := bubblewrap.failure(processes.python(), visible_files.readable())):
        dropped["bubblewrap"] = why
    return dropped


@functools.cache
def _missing_on_linux() -> dict[str, str]:
    missing = {}
    if not visible_files.can_be_narrow():
        missing["filesystem"] = "Python's own folder holds a home folder, the temporary folder or the current one"
    elif not _landlock.is_available():
        missing["filesystem"] = "this kernel has no Landlock (Linux 5.13 and newer, if it is switched on)"
    if not _seccomp.is_available():
        machines = " and ".join(_seccomp.MACHINES)
        missing["system_calls"] = f"this kernel takes no filters (seccomp), or this is not {machines}"
    return missing


def _has_bubblewrap() -> bool:
    return visible_files.can_be_narrow() and bubblewrap.works(processes.python(), visible_files.readable())


def prefix(layers: tuple[str, ...], private: Path) -> list[str]:
    """Return the arguments that precede the command that starts a program."""
    return bubblewrap.prefix(processes.python(), visible_files.readable(), private) if "bubblewrap" in layers else []


def set_by_process(layers: tuple[str, ...], *, portable: bool) -> list[str]:
    """Return the layers that the program's process has to set itself.

    ``portable``: the kernel does not end children with their parent; a thread of theirs watches instead.
    """
    ours = {"clean_environment", "private_folder"}
    if portable or sys.platform != "linux" or "bubblewrap" in layers:
        ours.add("ends_with_parent")
    if sys.platform == "win32":
        ours.add("resource_limits")  # the job object's
    return [layer for layer in layers if layer not in ours]


def limit_settings(limits: Limits, layers: tuple[str, ...], private: Path, *, portable: bool) -> dict[str, Any]:
    """Return the limits as sent to the program's process, sizes in bytes; ``portable`` as for `set_by_process`."""
    limited = "resource_limits" in layers
    readable, writable = list(visible_files.readable()), list(visible_files.DEVICES)
    files = {"readable": readable, "writable": writable, "private": str(private)}
    return {
        **(files if "filesystem" in layers else {}),
        "message_bytes": message_bytes(limits),
        "output_bytes": output_bytes(limits),
        "memory_bytes": memory_bytes(limits),
        "file_bytes": megabytes(limits.scratch_mb) + output_bytes(limits),
        "open_files": _OPEN_FILES,
        "processor_s": processor_s(limits),
        "user_tasks": _user_tasks(limits) if limited else 0,
        "parent": os.getpid(),
        # macOS takes no limit on memory; Windows has its job object.
        "watch_memory": limited and sys.platform != "win32" and (portable or sys.platform == "darwin"),
    }


def _user_tasks(limits: Limits) -> int:
    """Return the number of threads that the user may have with this program's; 0: no limit. Root has none."""
    if sys.platform != "linux" or os.geteuid() == 0 or not process_stats.tasks_of_user():
        return 0
    return process_stats.tasks_of_user() + _CROWD * limits.processes


def processor_s(limits: Limits) -> int:
    """Return the processor time that a program may use in a half, in s.

    The default leaves what it may use until its first step and in its steps, and as much again outside them, where
    only its own threads compute.
    """
    if limits.processor_s is not None:
        return math.ceil(limits.processor_s)
    return math.ceil(limits.start_s + _HALVES_OF_CPU_TIME * limits.half_s)


def megabytes(amount: float) -> int:
    """Return MB as bytes."""
    return int(amount * 1_000_000)


def message_bytes(limits: Limits) -> int:
    """Return the size of the largest radio packet in bytes."""
    return int(limits.message_kb * 1_000)


def output_bytes(limits: Limits) -> int:
    """Return the most that a program may print in a half, in bytes."""
    return megabytes(limits.output_mb)


def memory_bytes(limits: Limits) -> int:
    """Return the memory that a program may have, in bytes (MB of 1024² here, as memory is sold)."""
    return limits.memory_mb * 1024 * 1024


def environment(folder: Path) -> dict[str, str]:
    """Return the environment of a program: the same on every machine, apart from the path of its private folder."""
    place = str(folder)
    variables = {
        "HOME": place,
        "TMPDIR": place,
        # In case the user's number has no name: `getpass.getuser` looks here first.
        "USER": "robot",
        "LOGNAME": "robot",
        "LANG": "C.UTF-8",
        "LC_ALL": "C.UTF-8",
        "TZ": "UTC",
        "PATH": os.defpath,
        # Programs append its folders to their path; it contains nothing that they need.
        "WEBOTS_HOME": str(folder / "webots"),
        # Sets iterate in the same order in every run.
        "PYTHONHASHSEED": "0",
        # One core per program; without it OpenBLAS reserves 2 GB of address space on a machine of many cores.
        "OPENBLAS_NUM_THREADS": "1",
        # Else glibc reserves 64 MB of address space for each thread, which counts as memory.
        "MALLOC_ARENA_MAX": "1",
        "OMP_NUM_THREADS": "1",
        "MKL_NUM_THREADS": "1",
        "VECLIB_MAXIMUM_THREADS": "1",
    }
    if sys.platform == "win32":
        # Windows needs these to start programs and to find the temporary folder.
        variables |= {"SYSTEMROOT": os.environ.get("SYSTEMROOT", r"C:\Windows"), "TEMP": place, "TMP": place}
        variables |= {"USERPROFILE": place, "USERNAME": "robot", "APPDATA": place}
    return variables
