"""How programs and match share the processors (Linux; elsewhere nothing of this is done)."""

from __future__ import annotations

import contextlib
import ctypes
import functools
import os
import sys
from collections.abc import Callable
from typing import NamedTuple


class Manners(NamedTuple):
    """How programs behave towards the match: so that it is faster, and nothing else is.

    Attributes:
        gives_way: a program that is woken interrupts nobody who computes. Else it interrupts the match in the middle of
            telling other programs, for Linux likes to wake it where it was told.
        leaves: the processor that it leaves to the match, by its number; None: it leaves none.
        keeps_to: the only one on which it may be; None: it may be on all others.
    """

    gives_way: bool
    leaves: int | None = None
    keeps_to: int | None = None


AS_EVERYBODY = Manners(gives_way=False)
"""How every process takes its turn."""


def processor_here() -> int | None:
    """Return the number of the processor on which this thread is now; None where nobody tells."""
    told = _sched_getcpu()()
    return told if told >= 0 else None


def behave(pid: int, manners: Manners) -> None:
    """Let all threads of a process behave like that from now on; one that is gone is none the worse for it.

    It may be on no processors but those on which this thread may be: of these on the one to which it keeps, or on all
    but the one that it leaves, if there are others.
    """
    if sys.platform != "linux":
        return
    policy = os.SCHED_BATCH if manners.gives_way else os.SCHED_OTHER
    ours = os.sched_getaffinity(0)
    wanted = ours - {manners.leaves} if manners.keeps_to is None else ours & {manners.keeps_to}
    where = wanted or ours
    with contextlib.suppress(OSError):
        for thread in os.listdir(f"/proc/{pid}/task"):  # noqa: PTH208 - a match waits
            with contextlib.suppress(OSError):  # it has ended
                os.sched_setscheduler(int(thread), policy, os.sched_param(0))
                os.sched_setaffinity(int(thread), where)


@functools.cache
def _sched_getcpu() -> Callable[[], int]:
    """Return the function of the C library that tells it: looking at ``/proc`` takes ten times as long."""
    if sys.platform == "linux":
        with contextlib.suppress(OSError, AttributeError):
            found: Callable[[], int] = ctypes.CDLL(None).sched_getcpu
            return found
    return lambda: -1
