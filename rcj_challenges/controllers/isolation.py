"""How a team's program is kept from everything that is not its own: which layers, and how each is asked for.

The one seam for isolation. A layer is either how the parent starts the process (its environment, folder, session) or
something that the process sets itself before the program's first line (``pupil/controller/_confine.py``). What a
platform cannot do is missing from `active_layers`, and records say so.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import Any

from rcj_challenges.facts.errors import RcjError
from rcj_challenges.scenario.models.scenario import Limits

SANDBOXES = ("auto", "strict", "off")

LAYERS: dict[str, str] = {
    "clean_environment": "none of the parent's environment variables",
    "private_folder": "a copy of the team's files as current directory, discarded afterwards",
    "ends_with_parent": "no process outlives the match, however the match ends",
    "resource_limits": "limited memory, file size and open files",
    "no_new_privileges": "no privileges by setuid programs",
    "filesystem": "no sight of files that are not the program's",
    "system_calls": "no network, no new processes, no tracing",
}
"""All layers of a strict run, and what each is for."""

_ALWAYS = ("clean_environment", "private_folder", "ends_with_parent")
_OPEN_FILES = 256


class IsolationError(RcjError):
    """Strict isolation was asked for and cannot be had."""


def active_layers(sandbox: str, platform: str = sys.platform) -> tuple[str, ...]:
    """Return the layers that programs get on this platform.

    Args:
        sandbox: ``auto`` takes what there is, ``strict`` refuses to go without one, ``off`` takes only what keeps
            runs tidy.
        platform: as ``sys.platform`` names it.

    Raises:
        IsolationError: ``strict``, and layers are missing; or no such sandbox.
    """
    if sandbox not in SANDBOXES:
        raise IsolationError(f"unknown sandbox {sandbox!r}: expected {', '.join(SANDBOXES)}")
    if sandbox == "off":
        return _ALWAYS
    layers: tuple[str, ...] = (*_ALWAYS, "resource_limits")
    if platform == "linux":
        layers = (*layers, "no_new_privileges")
    if sandbox == "strict" and (missing := [layer for layer in LAYERS if layer not in layers]):
        told = "; ".join(f"{layer} ({LAYERS[layer]})" for layer in missing)
        raise IsolationError(f"--sandbox strict: these layers cannot be had here: {told}")
    return layers


def set_by_process(layers: tuple[str, ...], *, portable: bool) -> list[str]:
    """Return the layers that the program's process has to set itself.

    Args:
        layers: the active ones.
        portable: True where the kernel does not end children with their parent: a thread of theirs watches instead.
    """
    ours = {"clean_environment", "private_folder"}
    if portable or sys.platform != "linux":
        ours.add("ends_with_parent")
    if sys.platform == "win32":
        ours.add("resource_limits")  # the job object's
    return [layer for layer in layers if layer not in ours]


def limits_told(limits: Limits, layers: tuple[str, ...], *, portable: bool) -> dict[str, Any]:
    """Return the limits as the program's process is told them, sizes in bytes."""
    limited = "resource_limits" in layers
    return {
        "message_bytes": message_bytes(limits),
        "output_bytes": output_bytes(limits),
        "memory_bytes": memory_bytes(limits),
        "file_bytes": megabytes(limits.scratch_mb) + output_bytes(limits),
        "open_files": _OPEN_FILES,
        "parent": os.getpid(),
        # macOS takes no limit on memory; Windows has its job object.
        "watch_memory": limited and sys.platform != "win32" and (portable or sys.platform == "darwin"),
    }


def megabytes(amount: float) -> int:
    """Return MB as bytes."""
    return int(amount * 1_000_000)


def message_bytes(limits: Limits) -> int:
    """Return the size of the largest radio packet in bytes."""
    return int(limits.message_kb * 1_000)


def output_bytes(limits: Limits) -> int:
    """Return what a program may print in a half, in bytes."""
    return megabytes(limits.output_mb)


def memory_bytes(limits: Limits) -> int:
    """Return the memory that a program may have, in bytes (MB of 1024² here, as memory is sold)."""
    return limits.memory_mb * 1024 * 1024


def environment(folder: Path) -> dict[str, str]:
    """Return the environment of a program: the same on every machine, apart from the path of its folder.

    Args:
        folder: its private folder; home and temporary files are there too.
    """
    place = str(folder)
    told = {
        "HOME": place,
        "TMPDIR": place,
        "LANG": "C.UTF-8",
        "LC_ALL": "C.UTF-8",
        "TZ": "UTC",
        "PATH": os.defpath,
        # Sets iterate in the same order in every run.
        "PYTHONHASHSEED": "0",
        # One core per program; without it OpenBLAS reserves 2 GB of address space on a machine of many cores.
        "OPENBLAS_NUM_THREADS": "1",
        "OMP_NUM_THREADS": "1",
        "MKL_NUM_THREADS": "1",
        "VECLIB_MAXIMUM_THREADS": "1",
    }
    if sys.platform == "win32":
        # Without these, Windows starts no program and finds no temporary folder.
        told |= {"SYSTEMROOT": os.environ.get("SYSTEMROOT", r"C:\Windows"), "TEMP": place, "TMP": place}
        told |= {"USERPROFILE": place, "APPDATA": place}
    return told
