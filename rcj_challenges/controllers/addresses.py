"""Where a program's memory lies: at the same addresses in every run, where the system allows it (Linux).

The hash of an object without one of its own comes from its address, in Python 3.11 that of ``None`` too, and so does
the order in which a set of such objects is gone through. At random addresses the same program would play another match.
"""

from __future__ import annotations

import contextlib
import ctypes
import functools
import sys
from collections.abc import Iterator

_NOT_AT_RANDOM = 0x0040000
_ASK = 0xFFFFFFFF
"""Source: ``sys/personality.h`` (``ADDR_NO_RANDOMIZE``), and ``personality(2)``."""


@contextlib.contextmanager
def fixed() -> Iterator[None]:
    """Let what this thread starts meanwhile have its memory at fixed addresses; this process keeps its own.

    A container may refuse it, and other systems have nothing like it: then the addresses stay random.
    """
    before = _personality(_ASK)
    if before < 0 or _personality(before | _NOT_AT_RANDOM) < 0:
        yield
        return
    try:
        yield
    finally:
        _personality(before)


def _personality(wanted: int) -> int:
    """Set how this thread starts others, unless it is only asked for; return how it was, negative if refused."""
    call = _system_call()
    return int(call(wanted)) if call is not None else -1


@functools.cache
def _system_call() -> ctypes._NamedFuncPointer | None:
    if sys.platform != "linux":
        return None
    try:
        call = ctypes.CDLL(None).personality
    except (OSError, AttributeError):
        return None
    call.argtypes, call.restype = [ctypes.c_ulong], ctypes.c_int
    return call
