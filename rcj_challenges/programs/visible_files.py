"""Which files beside its own a program may see: Python, what it may import, and shared libraries.

The list is short, read-only and contains nothing else: an interpreter that lives in ``/`` or in somebody's
home folder must not open all of it.
"""

from __future__ import annotations

import contextlib
import functools
import os
import sys
import tempfile
from pathlib import Path

from rcj_challenges.programs.processes import PROGRAM_SIDE, site_folders

# Folders of shared libraries, as dynamic linkers search them; in the stores of Nix and Guix each library has a folder
# of its own. None of them is for secrets: all their files are public packages.
_LIBRARIES = ("/lib", "/lib32", "/lib64", "/usr/lib", "/usr/lib32", "/usr/lib64", "/usr/local/lib", "/nix/store")
_MORE_LIBRARIES = ("/gnu/store", "/etc/ld.so.cache")
# What the C library, OpenBLAS and `zoneinfo` ask the system: how many processors there are, how memory is given out,
# time zones. None of it reveals other processes.
_SYSTEM = ("/proc/cpuinfo", "/proc/sys/vm/overcommit_memory", "/sys/devices/system/cpu", "/usr/share/zoneinfo")

DEVICES = ("/dev/null", "/dev/zero", "/dev/full", "/dev/random", "/dev/urandom")
"""May be read and written."""


@functools.cache
def readable() -> tuple[str, ...]:
    """Return files and folders that a program may read, folders with all below them. Some may not exist."""
    protected = _protected()
    computed = [*standard_library(), *site_folders(), str(Path(sys.base_prefix, "lib")), str(PROGRAM_SIDE)]
    narrow = [path for path in map(os.path.realpath, computed) if not is_too_wide(path, protected)]
    return tuple(dict.fromkeys([*narrow, os.path.realpath(sys.executable), *_LIBRARIES, *_MORE_LIBRARIES, *_SYSTEM]))


def standard_library() -> list[str]:
    """Return the places of the interpreter's own modules: its folder, and an archive of them if there is one."""
    archives = [entry for entry in sys.path if entry.endswith(".zip") and entry.startswith(sys.base_prefix)]
    return [str(Path(os.__file__).parent), *archives]


def can_be_narrow() -> bool:
    """Return whether Python's own folders can be shown without exposing anything else."""
    protected = _protected()
    return not any(is_too_wide(os.path.realpath(path), protected) for path in [*standard_library(), str(PROGRAM_SIDE)])


def is_too_wide(path: str, protected: tuple[str, ...]) -> bool:
    """Return whether a folder is, or holds, one of those that must stay hidden; all without symbolic links."""
    return any(os.path.commonpath([path, place]) == path for place in protected)


def _protected() -> tuple[str, ...]:
    """Return the folders in which people and this match have their things, as far as they exist."""
    places = ["/", "/home", "/root", "/etc", "/var", "/run", "/proc"]
    for find in (Path.home, tempfile.gettempdir, Path.cwd):
        with contextlib.suppress(OSError, RuntimeError):
            places.append(str(find()))
    return tuple(map(os.path.realpath, places))
