"""The filter of system calls, judged by an interpreter of its language, for every machine that there is a table for."""

from __future__ import annotations

import errno
import re
from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from rcj_challenges.programs.program_side.controller import _seccomp
from rcj_challenges.programs.program_side.controller._syscalls import CALLS, IN_PART, PASSED_OVER, UNKNOWN

PID = 4321
EPERM = 0x00050000 | errno.EPERM
INVALID = 0x00050000 | errno.EINVAL
NO_SUCH_CALL = 0x00050000 | 38  # ENOSYS of Linux
WOKEN = 0x00050000 | errno.EAGAIN
NO_ERROR = 0x00050000  # an error of number 0
ALLOW = 0x7FFF0000
MACHINES = sorted(_seccomp.MACHINES)
FILTERS = {machine: _seccomp.filter_for(machine, PID) for machine in MACHINES}

AF_INET, AF_UNIX, SOCK_STREAM, SOCK_DGRAM, SOCK_CLOEXEC = 2, 1, 1, 2, 0o2000000
O_RDONLY, O_WRONLY, O_RDWR, O_TRUNC, O_CREAT, O_CLOEXEC = 0, 1, 2, 0o1000, 0o100, 0o2000000
THREAD = 0x3D0F00  # the flags with which the C library starts a thread
CLONE_FS, CLONE_FILES = 0x200, 0x400
CLONE_NEWUSER, CLONE_NEWNET, SIGCHLD = 0x10000000, 0x40000000, 17
REFUSED = {  # x86_64, aarch64
    "socket": (41, 198), "connect": (42, 203), "bind": (49, 200), "sendmsg": (46, 211), "setsockopt": (54, 208),
    "sendfile": (40, 71), "splice": (275, 76), "tee": (276, 77), "vmsplice": (278, 75), "fork": (57, None),
    "vfork": (58, None), "execve": (59, 221), "execveat": (322, 281), "setsid": (112, 157), "setpgid": (109, 154),
    "ptrace": (101, 117), "process_vm_readv": (310, 270), "process_madvise": (440, 440), "rt_sigqueueinfo": (129, 138),
    "rt_tgsigqueueinfo": (297, 240), "pidfd_open": (434, 434), "pidfd_getfd": (438, 438),
    "pidfd_send_signal": (424, 424), "unshare": (272, 97), "setns": (308, 268), "mount": (165, 40),
    "umount2": (166, 39), "open_tree": (428, 428), "fsopen": (430, 430), "pivot_root": (155, 41), "chroot": (161, 51),
    "keyctl": (250, 219), "bpf": (321, 280), "seccomp": (317, 277), "perf_event_open": (298, 241),
    "io_uring_setup": (425, 425), "userfaultfd": (323, 282), "memfd_create": (319, 279), "memfd_secret": (447, 447),
    "fchownat": (260, 54), "utimensat": (280, 88), "truncate": (76, 45), "fallocate": (285, 47), "setxattr": (188, 5),
    "setuid": (105, 146), "capset": (126, 91), "capget": (125, 90), "sched_setaffinity": (203, 122), "sched_setscheduler": (144, 119),
    "setpriority": (141, 140), "init_module": (175, 105), "reboot": (169, 142), "mq_open": (240, 180),
    "shmat": (30, 196), "cachestat": (451, 451),
}  # fmt: skip


def judge(machine: str, number: int, *arguments: int, architecture: int | None = None) -> int:
    """Run the filter as the kernel does."""
    arch = _seccomp.MACHINES[machine][1] if architecture is None else architecture
    words = {0: number & 0xFFFFFFFF, 4: arch}
    for index in range(6):
        value = arguments[index] if index < len(arguments) else 0
        words[16 + 8 * index] = value & 0xFFFFFFFF
        words[20 + 8 * index] = value >> 32 & 0xFFFFFFFF
    held, at = 0, 0
    while True:
        code, if_true, if_false, operand = FILTERS[machine][at]
        at += 1
        if code == 0x06:
            return operand
        if code == 0x20:
            held = words[operand]
        elif code == 0x54:
            held &= operand
        else:
            holds = {0x15: held == operand, 0x25: held > operand, 0x35: held >= operand}[code]
            at += if_true if holds else if_false


def in_part(machine: str, name: str, *arguments: int) -> int:
    number = IN_PART[name][_seccomp.MACHINES[machine][0]]
    assert number is not None
    return judge(machine, number, *arguments)


on_each_machine = pytest.mark.parametrize("machine", MACHINES)


@on_each_machine
def test_exactly_the_calls_of_the_table_are_allowed(machine: str) -> None:
    column = _seccomp.MACHINES[machine][0]
    allowed = {entry[column] for entry in CALLS.values()}
    other = {entry[column] for entry in (*IN_PART.values(), *UNKNOWN.values(), *PASSED_OVER.values())}
    last = max(number for number in allowed if number is not None)
    for number in range(last + 1):
        if number not in other:
            assert judge(machine, number) == (ALLOW if number in allowed else EPERM), number


@on_each_machine
@pytest.mark.parametrize("name", REFUSED)
def test_is_refused(machine: str, name: str) -> None:
    number = REFUSED[name][_seccomp.MACHINES[machine][0]]
    if number is None:
        pytest.skip(f"{machine} has no {name}")
    assert judge(machine, number) == EPERM


@on_each_machine
def test_permissions_locks_and_advice_have_no_effect_and_raise_no_error(machine: str) -> None:
    column = _seccomp.MACHINES[machine][0]
    answers = {judge(machine, numbers[column]) for numbers in PASSED_OVER.values() if numbers[column] is not None}
    assert answers == {NO_ERROR}
    assert {in_part(machine, "fcntl", 0, lock) for lock in (6, 7, 37, 38)} == {NO_ERROR}  # F_SETLK, F_OFD_SETLK, …


@on_each_machine
def test_calls_that_reveal_other_programs_do_not_exist(machine: str) -> None:
    column = _seccomp.MACHINES[machine][0]
    for name in ("mincore", "preadv2", "pwritev2", "sysinfo", "statfs", "fstatfs"):
        number = UNKNOWN[name][column]
        assert number is not None
        assert judge(machine, number) == NO_SUCH_CALL


@on_each_machine
def test_advice_on_memory_that_other_programs_can_measure_does_not_exist(machine: str) -> None:
    assert {in_part(machine, "madvise", 0, 0, advice) for advice in (0, 4, 8, 14, 102)} == {ALLOW}
    assert {in_part(machine, "madvise", 0, 0, advice) for advice in (12, 20, 21, 1000)} == {INVALID}


@on_each_machine
def test_all_threads_share_one_table_of_open_files(machine: str) -> None:
    assert {in_part(machine, "close_range", 3, 9, flags) for flags in (0, 4)} == {ALLOW}
    assert {in_part(machine, "close_range", 3, 9, flags) for flags in (2, 6, 1, 8)} == {EPERM}
    assert in_part(machine, "clone", THREAD & ~CLONE_FILES) == EPERM
    assert in_part(machine, "clone", THREAD & ~CLONE_FS) == EPERM


@on_each_machine
@given(number=st.integers(463, 2**32 - 1))
def test_calls_of_newer_kernels_and_of_the_x32_interface_do_not_exist(machine: str, number: int) -> None:
    assert judge(machine, number) == NO_SUCH_CALL


@on_each_machine
@given(number=st.integers(0, 500), architecture=st.integers(0, 2**32 - 1))
def test_no_call_passes_by_another_architecture(machine: str, number: int, architecture: int) -> None:
    if architecture != _seccomp.MACHINES[machine][1]:
        assert judge(machine, number, architecture=architecture) == EPERM


@on_each_machine
def test_threads_are_allowed_and_processes_and_name_spaces_are_not(machine: str) -> None:
    assert in_part(machine, "clone", THREAD) == ALLOW
    for flags in (SIGCHLD, 0, 0x4100 | SIGCHLD, THREAD | CLONE_NEWUSER, THREAD | CLONE_NEWNET, CLONE_NEWUSER):
        assert in_part(machine, "clone", flags) == EPERM
    assert judge(machine, 435) == NO_SUCH_CALL  # clone3: its flags are in memory


@on_each_machine
@given(pid=st.integers(-(2**31), 2**31 - 1))
def test_signals_reach_only_the_process_itself(machine: str, pid: int) -> None:
    answer = ALLOW if pid == PID else EPERM
    assert in_part(machine, "kill", pid, 9) == answer
    assert in_part(machine, "tgkill", pid, pid, 9) == answer
    assert in_part(machine, "tkill", pid, 9) == answer
    assert in_part(machine, "kill", PID, 9) == ALLOW


@on_each_machine
def test_threads_wait_for_each_other_and_not_for_other_programs(machine: str) -> None:
    """Operations are those of ``linux/futex.h``; by those without the private flag, programs would wake each other."""
    private, realtime = 128, 256
    answers = {operation: in_part(machine, "futex", 0, operation) for operation in range(14)}
    assert {operation for operation, answer in answers.items() if answer == WOKEN} == {0, 9}  # WAIT, WAIT_BITSET
    assert {operation for operation, answer in answers.items() if answer == NO_ERROR} == {1, 10}  # WAKE, WAKE_BITSET
    assert {answer for operation, answer in answers.items() if operation not in (0, 1, 9, 10)} == {EPERM}
    assert in_part(machine, "futex", 0, 9 | realtime) == WOKEN
    assert {in_part(machine, "futex", 0, operation | private) for operation in range(14)} == {ALLOW}
    assert in_part(machine, "futex", 0, 9 | private | realtime) == ALLOW
    column = _seccomp.MACHINES[machine][0]
    for name in ("futex_waitv", "futex_wake", "futex_wait", "futex_requeue"):
        number = UNKNOWN[name][column]
        assert number is not None
        assert judge(machine, number) == NO_SUCH_CALL


@on_each_machine
@given(clock=st.integers(-(2**31), 2**31 - 1))
@example(~PID << 3 | 2)
@example(~0 << 3 | 1)
@example(~(PID + 1) << 3 | 2)
def test_clocks_of_other_processes_are_refused(machine: str, clock: int) -> None:
    is_own = clock >= 0 or clock & 4 or (~(clock >> 3) in (0, PID) and clock & 3 != 3)
    for name in ("clock_gettime", "clock_getres", "clock_nanosleep", "timer_create"):
        assert in_part(machine, name, clock) == (ALLOW if is_own else EPERM)


@on_each_machine
@pytest.mark.parametrize("name", ["getpgid", "getsid"])
def test_sessions_are_its_own(machine: str, name: str) -> None:
    assert [in_part(machine, name, pid) for pid in (0, PID, 1, PID + 1)] == [ALLOW, ALLOW, EPERM, EPERM]


@on_each_machine
@pytest.mark.parametrize("name", ["sched_getaffinity", "sched_getparam", "sched_getscheduler", "sched_rr_get_interval"])
def test_libraries_do_without_the_scheduling_of_others(machine: str, name: str) -> None:
    answers = [in_part(machine, name, pid) for pid in (0, PID, 1, PID + 1)]
    assert answers == [ALLOW, ALLOW, NO_SUCH_CALL, NO_SUCH_CALL]


@on_each_machine
def test_priorities_are_its_own(machine: str) -> None:
    assert {in_part(machine, "getpriority", 0, pid) for pid in (0, PID)} == {ALLOW}
    refused = {in_part(machine, "getpriority", which, who) for which, who in ((0, PID + 1), (1, 0), (2, 0))}
    assert refused == {EPERM}


@on_each_machine
def test_limits_are_its_own(machine: str) -> None:
    assert [in_part(machine, "prlimit64", pid) for pid in (0, PID, 1, PID + 1)] == [ALLOW, ALLOW, EPERM, EPERM]


@on_each_machine
def test_what_is_opened_for_reading_is_not_emptied(machine: str) -> None:
    for name, place in (("open", 1), ("openat", 2)):
        if IN_PART[name][_seccomp.MACHINES[machine][0]] is None:
            continue
        for flags in (O_RDONLY, O_RDONLY | O_CLOEXEC, O_WRONLY | O_CREAT | O_TRUNC, O_RDWR | O_TRUNC, O_RDWR):
            assert in_part(machine, name, *[0] * place, flags) == ALLOW
        for flags in (O_RDONLY | O_TRUNC, O_RDONLY | O_TRUNC | O_CLOEXEC, 3 | O_TRUNC):
            assert in_part(machine, name, *[0] * place, flags) == EPERM


@on_each_machine
def test_socket_pairs_are_connected_to_each_other_alone(machine: str) -> None:
    assert in_part(machine, "socketpair", AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC) == ALLOW
    assert in_part(machine, "socketpair", AF_UNIX, SOCK_DGRAM) == EPERM
    assert in_part(machine, "socketpair", AF_INET, SOCK_STREAM) == EPERM


@on_each_machine
@pytest.mark.parametrize(
    ("name", "place", "allowed", "refused"),
    [
        ("fcntl", 1, (0, 1, 2, 3, 4, 1030, 1032), (5, 8, 10, 15, 36, 1024, 1026, 1031)),
        ("ioctl", 1, (0x5401, 0x541B, 0x5421), (0x5412, 0x541C, 0x40086602, 0x40049409)),
        ("prctl", 0, (15, 16), (1, 4, 8, 22, 36, 55)),
    ],
)
def test_calls_with_many_meanings_are_judged_by_meaning(
    machine: str, name: str, place: int, allowed: tuple[int, ...], refused: tuple[int, ...]
) -> None:
    assert {in_part(machine, name, *[0] * place, value) for value in allowed} == {ALLOW}
    assert {in_part(machine, name, *[0] * place, value) for value in refused} == {EPERM}


@on_each_machine
def test_the_kernel_takes_the_filter(machine: str) -> None:
    """At most 4096 instructions; every jump ends inside; the last one returns."""
    instructions = FILTERS[machine]
    assert len(instructions) <= 4096
    for at, (code, if_true, if_false, operand) in enumerate(instructions):
        assert 0 <= operand < 2**32
        assert at + 1 + max(if_true, if_false) < len(instructions) or code == 0x06
        assert 0 <= if_true < 256 > if_false >= 0
    assert instructions[-1][0] == 0x06


HEADER = Path("/usr/include/x86_64-linux-gnu/asm/unistd_64.h")


@pytest.mark.skipif(not HEADER.exists(), reason="the headers of Linux are not installed")
def test_numbers_are_those_of_the_kernels_headers() -> None:
    known = {name: int(number) for name, number in re.findall(r"__NR_(\w+) (\d+)", HEADER.read_text(encoding="utf-8"))}
    ours = {name: number for name, (number, _) in {**CALLS, **IN_PART, **UNKNOWN}.items() if name in known}
    assert len(ours) > 150
    assert ours == {name: known[name] for name in ours}
    refused = {name: number for name, (number, _) in REFUSED.items() if name in known}
    assert refused == {name: known[name] for name in refused}
