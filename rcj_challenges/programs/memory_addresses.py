"""Places a program's memory at the same addresses in every run, if the system allows it (Linux).

The default hash of an object comes from its address (in Python 3.11 also that of ``None``), and the iteration order of
a set comes from the hashes. With random addresses the same program would play a different match.
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
    """Start processes with fixed addresses from this thread meanwhile; this process keeps its own.

    If a container refuses it, or the system does not support it, addresses stay random.
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
    """Set the personality of this thread's processes, or only query it; return the old one, negative if refused."""
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
