"""Files: which ones a program's process may see (Landlock, Linux 5.13 and newer).

Deny by default: what is not below a folder that is named here cannot be opened, listed, made or removed, whoever owns
it. Newer kernels add more, which is also refused: connections by TCP (6.7), devices' controls (6.10), abstract sockets
and signals to processes outside (6.12). A process with such a domain cannot trace one without.
"""

from __future__ import annotations

import os
import stat
import sys
from struct import pack

from ._native import refuse_new_privileges, system_call

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

_CREATE_RULESET, _ADD_RULE, _RESTRICT_SELF = 444, 445, 446  # the same number on all architectures
_VERSION = 1  # LANDLOCK_CREATE_RULESET_VERSION
_PATH_BENEATH = 1  # LANDLOCK_RULE_PATH_BENEATH
_LOG_NOTHING = 1  # LANDLOCK_RESTRICT_SELF_LOG_SAME_EXEC_OFF: a program must not fill the system's log with refusals

# linux/landlock.h: rights to files and folders.
_WRITE_FILE, _READ_FILE, _READ_DIR, _REMOVE_DIR, _REMOVE_FILE = (1 << bit for bit in (1, 2, 3, 4, 5))
_MAKE_DIR, _MAKE_REG, _MAKE_SYM, _REFER, _TRUNCATE = (1 << bit for bit in (7, 8, 12, 13, 14))
_RIGHTS_OF_ABI = {1: 13, 2: 14, 3: 15, 4: 15}
"""How many rights the first versions know; from the fifth on there are 16."""
_NEWEST_RIGHTS = 16
_TCP = 0b11  # bind, connect: from version 4
_SCOPES = 0b11  # abstract sockets, signals: from version 6

_READ = _READ_FILE | _READ_DIR
_OWN = _READ | _WRITE_FILE | _REMOVE_DIR | _REMOVE_FILE | _MAKE_DIR | _MAKE_REG | _MAKE_SYM | _REFER | _TRUNCATE
_OF_FILES = _READ_FILE | _WRITE_FILE | _TRUNCATE


def version() -> int:
    """Return the version of Landlock's interface (ABI) that this kernel has; 0: none.

    Raises:
        OSError: the kernel has none, or it is switched off.
    """
    return system_call(_CREATE_RULESET, None, 0, _VERSION)


def is_available() -> bool:
    """Return whether this kernel has Landlock and it is switched on."""
    try:
        return sys.platform == "linux" and version() > 0
    except OSError:
        return False


def restrict_files(settings: dict[str, Any]) -> None:
    """Allow the files that the parent names, for this thread and all that it starts, for ever.

    The settings ``readable``, ``writable`` (devices, not their folder) and ``private`` (a folder) have paths.

    Raises:
        OSError: this kernel cannot.
    """
    abi = version()
    handled = (1 << _RIGHTS_OF_ABI.get(abi, _NEWEST_RIGHTS)) - 1
    attributes = pack("=Q", handled)
    if abi >= 4:
        attributes += pack("=Q", _TCP)
    if abi >= 6:
        attributes += pack("=Q", _SCOPES)
    rules = system_call(_CREATE_RULESET, attributes, len(attributes), 0)
    try:
        for path in settings["readable"]:
            _allow(rules, path, _READ & handled)
        for path in settings["writable"]:
            _allow(rules, path, (_READ_FILE | _WRITE_FILE) & handled)
        _allow(rules, settings["private"], _OWN & handled)
        _allow(rules, "/proc/self", _READ & handled)
        refuse_new_privileges()
        system_call(_RESTRICT_SELF, rules, _LOG_NOTHING if abi >= 7 else 0)
    finally:
        os.close(rules)


def _allow(rules: int, path: str, rights: int) -> None:
    """Add a rule for a file, or for a folder and all below it. Missing ones are skipped."""
    try:
        place = os.open(path, os.O_PATH | os.O_CLOEXEC)
    except (FileNotFoundError, NotADirectoryError, PermissionError):
        return
    try:
        if not stat.S_ISDIR(os.fstat(place).st_mode):
            rights &= _OF_FILES
        system_call(_ADD_RULE, rules, _PATH_BENEATH, pack("=Qi", rights, place), 0)
    finally:
        os.close(place)
