"""Statistics of processes from the operating system: numbers of threads (Linux), CPU times."""

from __future__ import annotations

import contextlib
import functools
import os
import subprocess
import sys
import time

from rcj_challenges.programs.time_budget import ProcessTimes, ThreadTimes

_LINKS_OF_A_FOLDER = 2  # itself and its parent; each further one is a folder in it, here a thread


def threads_of(pid: int) -> int:
    """Return the number of threads of a process; 0 if that is unknown, or if there is no such process."""
    try:
        return max(0, os.stat(f"/proc/{pid}/task").st_nlink - _LINKS_OF_A_FOLDER)  # noqa: PTH116 - called while a match waits
    except OSError:
        return 0


def has_lost_main_thread(pid: int) -> bool:
    """Return whether the main thread of a process has ended and others run on; False if that is unknown.

    Then ``/proc/PID/fd`` is empty, whatever they have open. A process that is ending may look the same for a moment.
    """
    return _state(pid, pid) == b"Z" and threads_of(pid) > 1


@functools.cache
def tasks_of_user() -> int:
    """Return the number of threads of all processes of this user at the first call; 0: not known.

    ``RLIMIT_NPROC`` counts all of them together, so a limit for one program can only be one above what there is.
    """
    user, total = os.geteuid(), 0
    with contextlib.suppress(OSError):
        for entry in os.scandir("/proc"):
            with contextlib.suppress(OSError):
                if entry.name.isdigit() and entry.stat().st_uid == user:
                    total += threads_of(int(entry.name))
    return total


def process_times(pid: int) -> ProcessTimes | None:
    """Return the kernel's counts for a process until now; None if they are unknown (Windows: the job object has them).

    A thread's numbers lag behind by up to 10 ms while it computes; those of a thread that waits are exact.
    """
    try:
        if sys.platform == "linux":
            clock = ~pid << 3 | 2  # of its processor time, as `clock_getcpuclockid` numbers it
            return ProcessTimes(time.clock_gettime(clock), _thread_times(pid))
        if sys.platform != "win32":
            listed = subprocess.run(["ps", "-o", "time=", "-p", str(pid)], capture_output=True, text=True, check=True)
            return ProcessTimes(seconds_of(listed.stdout), None)
    except (OSError, ValueError, subprocess.SubprocessError):
        pass
    return None


def _thread_times(pid: int) -> dict[int, ThreadTimes] | None:
    """Return the kernel's counts for each thread; None if it does not count."""
    times = {}
    for thread in os.listdir(f"/proc/{pid}/task"):  # noqa: PTH208 - a match waits
        with contextlib.suppress(FileNotFoundError, ProcessLookupError):
            path = f"/proc/{pid}/task/{thread}/schedstat"
            with open(path, "rb", buffering=0) as file:  # noqa: PTH123 - a match waits
                running_ns, ready_ns, runs = map(int, file.read().split())
            times[int(thread)] = ThreadTimes(running_ns / 1e9, ready_ns / 1e9, runs)
    return times if any(thread.runs for thread in times.values()) else None  # else all numbers are 0


def is_runnable(pid: int, thread: int) -> bool:
    """Return whether a thread runs or waits for a processor at this moment (Linux)."""
    return _state(pid, thread) == b"R"


def _state(pid: int, thread: int) -> bytes:
    """Return the letter of a thread's state, as in ``proc_pid_stat(5)``; nothing if it is unknown."""
    with contextlib.suppress(OSError, IndexError), open(f"/proc/{pid}/task/{thread}/stat", "rb", buffering=0) as file:  # noqa: PTH123
        return file.read().rpartition(b")")[2].split()[0]
    return b""


def held_up_here_s() -> float:
    """Return the time in which this thread was ready to compute and had no processor, in s; 0 if it is unknown."""
    if sys.platform == "linux":
        with contextlib.suppress(OSError, ValueError, IndexError), open("/proc/thread-self/schedstat", "rb") as file:  # noqa: PTH123
            return int(file.read().split()[1]) / 1e9
    return 0.0


def seconds_of(text: str) -> float:
    """Parse a time as ``ps`` prints it, in s: ``2-03:04:05``, ``4:05.06``."""
    days, _, clock = text.strip().rpartition("-")
    seconds = 0.0
    for part in clock.split(":"):
        seconds = 60 * seconds + float(part)
    return seconds + 86_400 * int(days or 0)
