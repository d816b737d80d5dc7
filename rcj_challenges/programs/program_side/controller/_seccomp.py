"""System calls: what a program's process may ask of the kernel (seccomp, Linux).

A filter in the kernel's own small language (classic BPF) judges every system call by its number and arguments. What is
refused fails with EPERM, in Python a ``PermissionError`` or another ``OSError``: the program gets an error and is not
killed.
"""

from __future__ import annotations

import os
import sys
from struct import Struct

from ._native import refuse_new_privileges, system_call
from ._syscalls import CALLS, IN_PART, PASSED_OVER, UNKNOWN

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

MACHINES = {"x86_64": (0, 0xC000003E), "aarch64": (1, 0xC00000B7)}
"""Column of the tables, and the architecture as filters see it (linux/audit.h); both little-endian, 64 bit."""

_SECCOMP = {"x86_64": 317, "aarch64": 277}
_SET_MODE_FILTER, _GET_ACTION_AVAIL = 1, 2  # linux/seccomp.h
_ALL_THREADS = 1  # SECCOMP_FILTER_FLAG_TSYNC
_KEEP_SPEED = 4  # SECCOMP_FILTER_FLAG_SPEC_ALLOW: kernels before 5.16 slow filtered processes down otherwise

ALLOW = 0x7FFF0000  # SECCOMP_RET_ALLOW
REFUSE = 0x00050001  # SECCOMP_RET_ERRNO, EPERM
INVALID = 0x00050016  # SECCOMP_RET_ERRNO, EINVAL
NOT_THERE = 0x00050026  # SECCOMP_RET_ERRNO, ENOSYS
AGAIN = 0x0005000B  # SECCOMP_RET_ERRNO, EAGAIN
PASS_OVER = 0x00050000  # SECCOMP_RET_ERRNO, no error

# linux/bpf_common.h: load a word of the call's description; compare; mask; return.
_LOAD, _EQUAL, _GREATER, _AT_LEAST, _MASK, _RETURN = 0x20, 0x15, 0x25, 0x35, 0x54, 0x06
_NUMBER_AT, _MACHINE_AT, _ARGUMENTS_AT = 0, 4, 16  # struct seccomp_data
_INSTRUCTION = Struct("<HBBI")
_WORD = Struct("=I")
_FILTER_POINTER = Struct("@HP")  # struct sock_fprog

Instruction = tuple[int, int, int, int]
"""Code, how many to skip if true, how many if false, operand."""

_THREAD_FLAGS = 0x00010600  # linux/sched.h: CLONE_THREAD, CLONE_FS, CLONE_FILES
_CLONE_NEW = 0x7E020080  # CLONE_NEW… of cgroup, uts, ipc, user, pid, net, mount, time
_O_TRUNC, _O_ACCMODE = 0o1000, 0o3  # asm-generic/fcntl.h
_TERMINAL_CONTROLS = (0x5401, 0x5402, 0x5403, 0x5404, 0x5413)  # TCGETS, TCSETS, TCSETSW, TCSETSF, TIOCGWINSZ
_FILE_IOCTLS = (0x541B, 0x5421, 0x5450, 0x5451)  # FIONREAD, FIONBIO, FIONCLEX, FIOCLEX
_CLOSE_RANGE_CLOEXEC = 4  # linux/close_range.h
# F_DUPFD, F_GETFD, F_SETFD, F_GETFL, F_SETFL, F_DUPFD_CLOEXEC, F_GETPIPE_SZ. Not F_SETOWN and F_SETSIG: they let the
# kernel send any signal to any process of the same user. Not F_SETPIPE_SZ: pipes are memory that no limit counts.
_FILE_CONTROLS = (0, 1, 2, 3, 4, 1030, 1032)
# F_SETLK, F_SETLKW, F_OFD_SETLK, F_OFD_SETLKW: without effect, like flock. F_GETLK and F_OFD_GETLK are refused: they
# would show the locks of others.
_LOCKS = (6, 7, 37, 38)
# asm-generic/mman-common.h: NORMAL to DONTNEED, FREE, DONTFORK, DOFORK, HUGEPAGE to DODUMP, WIPEONFORK, KEEPONFORK,
# POPULATE_…, GUARD_…. Not MERGEABLE, COLD and PAGEOUT: other programs can measure their effect on shared pages.
_MEMORY_ADVICE = (0, 1, 2, 3, 4, 8, 10, 11, 14, 15, 16, 17, 18, 19, 22, 23, 102, 103)
# PR_GET_DUMPABLE, PR_SET_NAME, PR_GET_NAME, PR_CAPBSET_READ, PR_GET_NO_NEW_PRIVS, PR_SET_VMA (names of memory).
_PROCESS_CONTROLS = (3, 15, 16, 23, 39, 0x53564D41)
_FUTEX_PRIVATE, _FUTEX_REALTIME = 0x80, 0x100  # linux/futex.h
_FUTEX_WAITS, _FUTEX_WAKES = (0, 9), (1, 10)  # WAIT, WAIT_BITSET; WAKE, WAKE_BITSET
_SCHEDULING = ("sched_getaffinity", "sched_getparam", "sched_getscheduler", "sched_rr_get_interval")
_PRIO_PROCESS = 0  # sys/resource.h
_CLOCKS = ("clock_gettime", "clock_getres", "clock_nanosleep", "timer_create")
_CLOCK_OF_THREAD = 4  # linux/posix-timers_types.h; the kernel has these clocks only for threads of the process itself
_AF_UNIX, _SOCK_STREAM, _SOCK_TYPES = 1, 1, 0xF


def is_available() -> bool:
    """Return whether this kernel takes filters that refuse, and there is a table for this machine."""
    if sys.platform != "linux" or os.uname().machine not in MACHINES or sys.maxsize < 2**32:
        return False
    try:
        system_call(_SECCOMP[os.uname().machine], _GET_ACTION_AVAIL, 0, _WORD.pack(REFUSE & 0xFFFF0000))
    except OSError:
        return False
    return True


def restrict_calls(settings: dict[str, Any]) -> None:  # noqa: ARG001 - all layers are called alike
    """Refuse the system calls that no program needs, from here on and for ever, in all threads.

    Raises:
        OSError: this kernel or machine cannot.
    """
    import ctypes  # noqa: PLC0415 - on Linux only

    machine = os.uname().machine
    if machine not in MACHINES:
        raise OSError(f"no table of system calls for {machine}")
    instructions = filter_for(machine, os.getpid())
    code = b"".join([_INSTRUCTION.pack(*instruction) for instruction in instructions])
    held = ctypes.create_string_buffer(code, len(code))
    program = _FILTER_POINTER.pack(len(instructions), ctypes.addressof(held))
    refuse_new_privileges()
    try:
        system_call(_SECCOMP[machine], _SET_MODE_FILTER, _ALL_THREADS | _KEEP_SPEED, program)
    except OSError:
        system_call(_SECCOMP[machine], _SET_MODE_FILTER, _ALL_THREADS, program)


def filter_for(machine: str, pid: int) -> list[Instruction]:
    """Return the filter for a machine of `MACHINES`. Signals to ``pid``, its own process, stay possible (``abort``)."""
    column, architecture = MACHINES[machine]
    filter_ = [(_LOAD, 0, 0, _MACHINE_AT), (_EQUAL, 1, 0, architecture), _answer(REFUSE), (_LOAD, 0, 0, _NUMBER_AT)]
    for table, answer in ((UNKNOWN, NOT_THERE), (PASSED_OVER, PASS_OVER)):
        for numbers in table.values():
            filter_ += _for_call(numbers[column], [_answer(answer)])
    for name, judged in _conditions(pid).items():
        filter_ += _for_call(IN_PART[name][column], judged)
    plain = [number for numbers in CALLS.values() if (number := numbers[column]) is not None]
    for first, last in _ranges(sorted(plain)):
        # In ascending order: what is beyond this range goes on to the next one, what is before it lies in a gap.
        filter_ += [(_GREATER, 3, 0, last), (_AT_LEAST, 0, 1, first), _answer(ALLOW), _answer(REFUSE)]
    # Beyond the last of the table are calls of newer kernels, and on x86_64 those of the x32 interface.
    filter_.append(_answer(NOT_THERE))
    return filter_


def _conditions(pid: int) -> dict[str, list[Instruction]]:
    """Return instructions for calls that are allowed in part; they end in an answer."""
    return {
        "open": _truncating(1),
        "openat": _truncating(2),
        # Not CLOSE_RANGE_UNSHARE: all threads share one table of open files, so that one look at it shows everything.
        "close_range": _one_of(2, (0, _CLOSE_RANGE_CLOEXEC)),
        "madvise": _one_of(2, _MEMORY_ADVICE, INVALID),
        # New threads that share their open files, but neither processes nor name spaces.
        "clone": _masked(0, _THREAD_FLAGS | _CLONE_NEW, (_THREAD_FLAGS,)),
        "kill": _one_of(0, (pid,)),
        "tgkill": _one_of(0, (pid,)),
        "tkill": _one_of(0, (pid,)),  # its first thread has its number; musl aborts this way
        "fcntl": [*_argument(1), *_compared(_LOCKS, PASS_OVER), *_compared(_FILE_CONTROLS, ALLOW), _answer(REFUSE)],
        # Not TIOCSTI, which types into a terminal, nor what changes attributes of files that can only be read.
        "ioctl": _one_of(1, _TERMINAL_CONTROLS + _FILE_IOCTLS),
        # Not PR_SET_PDEATHSIG, by which a program could outlive the match.
        "prctl": _one_of(0, _PROCESS_CONTROLS),
        **dict.fromkeys(("prlimit64", "getpgid", "getsid"), _one_of(0, (0, pid))),
        # Libraries ask for those of their threads, and do without if there is no such call.
        **dict.fromkeys(_SCHEDULING, _one_of(0, (0, pid), NOT_THERE)),
        "getpriority": [*_argument(0), (_EQUAL, 1, 0, _PRIO_PROCESS), _answer(REFUSE), *_one_of(1, (0, pid))],
        **dict.fromkeys(_CLOCKS, _own_clock(0, pid)),
        "futex": _between_own_threads(1),
        # Not SOCK_DGRAM, which sends to any address.
        "socketpair": [
            *_argument(0),
            (_EQUAL, 1, 0, _AF_UNIX),
            _answer(REFUSE),
            *_masked(1, _SOCK_TYPES, (_SOCK_STREAM,)),
        ],
    }


def _truncating(flags: int) -> list[Instruction]:
    """Refuse to empty a file that is opened for reading: Landlock before Linux 6.2 takes that for reading."""
    unwritable = (_O_TRUNC, _O_TRUNC | _O_ACCMODE)  # with O_RDONLY; with 3, which is for neither
    return [
        *_argument(flags),
        (_MASK, 0, 0, _O_TRUNC | _O_ACCMODE),
        *_compared(unwritable, REFUSE),
        _answer(ALLOW),
    ]


def _between_own_threads(operation: int) -> list[Instruction]:
    """Let only threads of this process wait for each other, and not others that map the same library.

    A shared wait returns at once, and its caller looks at the value again: `pthread_join` and C++ wait like this for
    their own threads. If it slept, another process could wake it even without a call, by the end of a thread.
    """
    return [
        *_argument(operation),
        (_MASK, 0, 0, _FUTEX_PRIVATE),
        *_compared((_FUTEX_PRIVATE,), ALLOW),
        *_argument(operation),
        (_MASK, 0, 0, ~_FUTEX_REALTIME & 0xFFFFFFFF),
        *_compared(_FUTEX_WAITS, AGAIN),
        *_compared(_FUTEX_WAKES, PASS_OVER),
        _answer(REFUSE),
    ]


def _own_clock(clock: int, pid: int) -> list[Instruction]:
    """Refuse CPU clocks of other processes: negative numbers, made of the process and one of three kinds."""
    own = tuple((~process << 3 | kind) & 0xFFFFFFFF for process in (0, pid) for kind in range(3))
    return [
        *_argument(clock),
        (_AT_LEAST, 1, 0, 0x80000000),
        _answer(ALLOW),
        *_compared(own, ALLOW),
        (_MASK, 0, 0, _CLOCK_OF_THREAD),
        *_compared((_CLOCK_OF_THREAD,), ALLOW),
        _answer(REFUSE),
    ]


def _one_of(argument: int, allowed: tuple[int, ...], otherwise: int = REFUSE) -> list[Instruction]:
    return [*_argument(argument), *_compared(allowed, ALLOW), _answer(otherwise)]


def _masked(argument: int, mask: int, allowed: tuple[int, ...]) -> list[Instruction]:
    return [*_argument(argument), (_MASK, 0, 0, mask), *_compared(allowed, ALLOW), _answer(REFUSE)]


def _argument(index: int) -> list[Instruction]:
    """Load the lower half of an argument: of all arguments that are judged the kernel takes only that, too."""
    return [(_LOAD, 0, 0, _ARGUMENTS_AT + 8 * index)]


def _compared(values: tuple[int, ...], answer: int) -> list[Instruction]:
    instructions: list[Instruction] = []
    for value in values:
        instructions += [(_EQUAL, 0, 1, value), _answer(answer)]
    return instructions


def _answer(answer: int) -> Instruction:
    return _RETURN, 0, 0, answer


def _for_call(number: int | None, judged: list[Instruction]) -> list[Instruction]:
    """Judge the call of this number; others, whose number stays loaded, go on behind."""
    return [] if number is None else [(_EQUAL, 0, len(judged), number), *judged]


def _ranges(numbers: list[int]) -> list[tuple[int, int]]:
    ranges: list[tuple[int, int]] = []
    for number in numbers:
        if ranges and ranges[-1][1] == number - 1:
            ranges[-1] = (ranges[-1][0], number)
        else:
            ranges.append((number, number))
    return ranges
