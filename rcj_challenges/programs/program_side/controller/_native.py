"""Calls to the C library that Python has no module for (Linux). Everything here is for ``_confine`` and its layers."""

# ruff: noqa: PLC0415 - ctypes is imported where there is Linux, after limits that need no ctypes

from __future__ import annotations

import os
from struct import pack

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

PR_SET_PDEATHSIG = 1  # linux/prctl.h
_PR_SET_NO_NEW_PRIVS = 38
_CAPABILITIES_VERSION = 0x20080522  # _LINUX_CAPABILITY_VERSION_3
_CAP_DAC_READ_SEARCH = 2

_libc: Any = None


def libc() -> Any:
    """Return the C library of this process."""
    global _libc  # noqa: PLW0603 - loaded once, where it is needed
    if _libc is None:
        import ctypes

        _libc = ctypes.CDLL(None, use_errno=True)
        _libc.syscall.restype = ctypes.c_long
    return _libc


def checked(result: int) -> int:
    """Return the result of a call of the C library.

    Raises:
        OSError: it was -1.
    """
    if result == -1:
        import ctypes

        errno = ctypes.get_errno()
        raise OSError(errno, os.strerror(errno))
    return result


def system_call(number: int, *arguments: int | bytes | None) -> int:
    """Make a system call that the C library has no function for; numbers are passed as ``long``, bytes by address.

    Raises:
        OSError: it failed.
    """
    import ctypes

    passed = [ctypes.c_long(argument) if isinstance(argument, int) else argument for argument in arguments]
    return checked(libc().syscall(ctypes.c_long(number), *passed))


def process_control(option: int, value: int) -> None:
    """Call ``prctl``.

    Raises:
        OSError: it failed.
    """
    import ctypes

    checked(libc().prctl(option, ctypes.c_ulong(value), *[ctypes.c_ulong(0)] * 3))


def refuse_new_privileges() -> None:
    """Make setuid programs start without their privileges; the kernel demands it before the layers that filter.

    Raises:
        OSError: it failed.
    """
    process_control(_PR_SET_NO_NEW_PRIVS, 1)


def drop_capabilities() -> None:
    """Give up what root may do beyond others, except to read files: Python itself may be in a folder of root's.

    Raises:
        OSError: it failed.
    """
    kept = 1 << _CAP_DAC_READ_SEARCH if os.geteuid() == 0 else 0
    # Effective, permitted, inheritable of the capabilities 0 to 31, then of those from 32 on.
    permitted = _permitted() & kept
    checked(libc().capset(pack("=Ii", _CAPABILITIES_VERSION, 0), pack("=6I", permitted, permitted, 0, 0, 0, 0)))


def _permitted() -> int:
    import ctypes

    data = ctypes.create_string_buffer(24)
    checked(libc().capget(pack("=Ii", _CAPABILITIES_VERSION, 0), data))
    return int.from_bytes(data.raw[4:8], "little")
