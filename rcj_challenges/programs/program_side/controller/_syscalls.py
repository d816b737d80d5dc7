"""System calls of Linux that a program may make, by name, with their numbers on x86_64 and aarch64.

Everything that is not here is refused: a program reads and writes its own files, computes, waits and has threads, and
needs nothing else. Numbers as in ``arch/x86/entry/syscalls/syscall_64.tbl`` and ``include/uapi/asm-generic/unistd.h``
of Linux 6.12; a number never changes its meaning. None: not on this architecture.
"""

from __future__ import annotations

# What is missing is missing on purpose. Not obvious are: chown, utime and setxattr in all forms, and truncate by
# path: Landlock does not look at these (at truncate only since Linux 6.2) and would leave all files of this user in
# reach (the same holds for chmod, see `PASSED_OVER`); memfd_create, message queues and shared memory of System V,
# setsockopt (sizes of buffers), splice, tee and sendfile (pipes keep large blocks of a file's pages), which hold
# memory that no limit counts; setpriority and sched_set…, which slow others down; sync, which waits for everybody's
# files; fallocate, which fills a disk at once, with files that are said to be empty.
CALLS: dict[str, tuple[int | None, int | None]] = {
    # files and folders: Landlock decides which
    "read": (0, 63), "write": (1, 64), "close": (3, 57), "lseek": (8, 62), "pread64": (17, 67), "pwrite64": (18, 68),
    "readv": (19, 65), "writev": (20, 66), "preadv": (295, 69), "pwritev": (296, 70), "dup": (32, 23),
    "dup2": (33, None), "dup3": (292, 24), "pipe": (22, None), "pipe2": (293, 59), "creat": (85, None),
    "fstat": (5, 80), "stat": (4, None), "lstat": (6, None), "newfstatat": (262, 79), "statx": (332, 291),
    "access": (21, None), "faccessat": (269, 48), "faccessat2": (439, 439), "readlink": (89, None),
    "readlinkat": (267, 78), "getdents": (78, None), "getdents64": (217, 61), "getcwd": (79, 17), "chdir": (80, 49),
    "fchdir": (81, 50), "mkdir": (83, None), "mkdirat": (258, 34), "rmdir": (84, None), "unlink": (87, None),
    "unlinkat": (263, 35), "rename": (82, None), "renameat": (264, 38), "renameat2": (316, 276), "link": (86, None),
    "linkat": (265, 37), "symlink": (88, None), "symlinkat": (266, 36), "umask": (95, 166), "ftruncate": (77, 46),
    "fsync": (74, 82), "fdatasync": (75, 83), "readahead": (187, 213), "copy_file_range": (326, 285),
    "getxattr": (191, 8), "lgetxattr": (192, 9), "fgetxattr": (193, 10), "listxattr": (194, 11),
    "llistxattr": (195, 12), "flistxattr": (196, 13),
    # waiting
    "select": (23, None), "pselect6": (270, 72), "poll": (7, None), "ppoll": (271, 73), "epoll_create": (213, None),
    "epoll_create1": (291, 20), "epoll_ctl": (233, 21), "epoll_wait": (232, None), "epoll_pwait": (281, 22),
    "epoll_pwait2": (441, 441), "eventfd": (284, None), "eventfd2": (290, 19), "timerfd_create": (283, 85),
    "timerfd_settime": (286, 86), "timerfd_gettime": (287, 87), "signalfd": (282, None), "signalfd4": (289, 74),
    "wait4": (61, 260), "waitid": (247, 95),
    # its own memory
    "mmap": (9, 222), "munmap": (11, 215), "mprotect": (10, 226), "mremap": (25, 216), "brk": (12, 214),
    "msync": (26, 227), "mseal": (462, 462), "pkey_alloc": (330, 289), "pkey_free": (331, 290),
    "pkey_mprotect": (329, 288), "map_shadow_stack": (453, 453),
    # its own threads
    "set_robust_list": (273, 99), "set_tid_address": (218, 96), "rseq": (334, 293),
    "arch_prctl": (158, None), "gettid": (186, 178), "sched_yield": (24, 124),
    "sched_get_priority_max": (146, 125), "sched_get_priority_min": (147, 126), "getcpu": (309, 168),
    "membarrier": (324, 283), "exit": (60, 93), "exit_group": (231, 94), "restart_syscall": (219, 128),
    # signals to itself, timers
    "rt_sigaction": (13, 134), "rt_sigprocmask": (14, 135), "rt_sigreturn": (15, 139), "rt_sigpending": (127, 136),
    "rt_sigtimedwait": (128, 137), "rt_sigsuspend": (130, 133), "sigaltstack": (131, 132), "pause": (34, None),
    "alarm": (37, None), "setitimer": (38, 103), "getitimer": (36, 102), "timer_settime": (223, 110),
    "timer_gettime": (224, 108), "timer_getoverrun": (225, 109), "timer_delete": (226, 111),
    # clocks
    "nanosleep": (35, 101), "gettimeofday": (96, 169), "time": (201, None), "times": (100, 153),
    # its own ids and limits
    "getpid": (39, 172), "getppid": (110, 173), "getuid": (102, 174), "geteuid": (107, 175), "getgid": (104, 176),
    "getegid": (108, 177), "getresuid": (118, 148), "getresgid": (120, 150), "getgroups": (115, 158),
    "getpgrp": (111, None), "uname": (63, 160), "getrusage": (98, 165), "getrlimit": (97, 163),
    "setrlimit": (160, 164), "getrandom": (318, 278),
    # the two ends of a socket pair, which asyncio wakes itself with
    "sendto": (44, 206), "recvfrom": (45, 207), "shutdown": (48, 210), "getsockopt": (55, 209),
    "getsockname": (51, 204), "getpeername": (52, 205),
}  # fmt: skip

IN_PART: dict[str, tuple[int | None, int | None]] = {
    "open": (2, None), "openat": (257, 56), "close_range": (436, 436), "madvise": (28, 233), "clone": (56, 220),
    "kill": (62, 129), "tgkill": (234, 131), "tkill": (200, 130), "fcntl": (72, 25), "ioctl": (16, 29),
    "prctl": (157, 167), "prlimit64": (302, 261), "socketpair": (53, 199), "futex": (202, 98),
    "clock_gettime": (228, 113), "clock_getres": (229, 114), "clock_nanosleep": (230, 115), "timer_create": (222, 107),
    "getpgid": (121, 155), "getsid": (124, 156), "getpriority": (140, 141), "sched_getaffinity": (204, 123),
    "sched_getparam": (143, 121), "sched_getscheduler": (145, 120), "sched_rr_get_interval": (148, 127),
}  # fmt: skip
"""Allowed with some arguments, which ``_seccomp`` judges."""

UNKNOWN: dict[str, tuple[int | None, int | None]] = {
    "clone3": (435, 435), "openat2": (437, 437), "preadv2": (327, 286), "pwritev2": (328, 287), "mincore": (27, 232),
    "statfs": (137, 43), "fstatfs": (138, 44), "sysinfo": (99, 179), "futex_waitv": (449, 449),
    "futex_wake": (454, 454), "futex_wait": (455, 455), "futex_requeue": (456, 456),
}  # fmt: skip
"""Answered as by a kernel that does not have them, so that libraries fall back. The arguments of the first two are in
memory, where no filter can look: the C library then makes older calls that can be judged. Those of futexes could wake
other programs. The others reveal what other programs do: which pages of files they have read, and how much memory and
disk space they use."""

PASSED_OVER: dict[str, tuple[int | None, int | None]] = {
    "chmod": (90, None),
    "fchmod": (91, 52),
    "fchmodat": (268, 53),
    "fchmodat2": (452, 452),
    "flock": (73, 32),
    "fadvise64": (221, 223),
}
"""Reported as successful without being carried out. Permissions: as on a disk without them, because ``shutil.copy``
ends with such a call; not utime: ``Path.touch`` takes its success to mean that the file is there. Locks: a file that
can be written belongs to one program, and locks on shared files would carry messages; so would dropping the pages of
such files."""
