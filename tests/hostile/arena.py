"""What the hostile programs share: driving until the attack, and saying what came of it. Copied into their team.

Every program drives ahead until a tick of its choice and sets speed 0 there; so whatever becomes of it afterwards,
its robot must move as that of a program which sets speed 0 at that tick and stays.
"""

from controller import Robot

robot = None
motors = []


def start():
    """Make the robot; its wheels turn freely, at speed 0."""
    global robot
    robot = Robot()
    for side in ("left", "right"):
        motor = robot.getDevice(side + " wheel motor")
        motor.setPosition(float("inf"))
        motor.setVelocity(0)
        motors.append(motor)
    return robot


def drive(ticks):
    """Go ahead until ``ticks``; from then on the wheels are to stand."""
    start()
    for motor in motors:
        motor.setVelocity(10)
    for _ in range(ticks):
        robot.step(32)
    for motor in motors:
        motor.setVelocity(0)
    return robot


def refused(what, deed, *arguments, **options):
    """Try a deed that must not succeed; say so if it does."""
    try:
        result = deed(*arguments, **options)
    except Exception as error:
        print("refused:", what, type(error).__name__)
        return None
    print("BROKEN:", what, repr(result)[:200])
    return result


def play_on():
    """Keep to the match until it is over."""
    print("plays on from", round(robot.getTime(), 3), flush=True)
    while robot.step(32) != -1:
        pass


def hang():
    """Wait for ever, in real time and without computing."""
    import _thread

    lock = _thread.allocate_lock()
    lock.acquire()
    lock.acquire()


def libc():
    """The C library, with errno."""
    import ctypes

    return ctypes.CDLL(None, use_errno=True)


def syscall(what, number, *arguments, fine=()):
    """Make a system call that must not be carried out: refused is EPERM, EACCES or ENOSYS, or one of ``fine``."""
    import ctypes
    import errno

    ctypes.set_errno(0)
    given = [
        argument
        if argument is None or isinstance(argument, (bytes, ctypes._SimpleCData)) or hasattr(argument, "_obj")
        else ctypes.c_long(argument)
        for argument in arguments
    ]
    result = libc().syscall(ctypes.c_long(number), *given)
    name = errno.errorcode.get(ctypes.get_errno(), "?")
    if result == -1 and name in ("EPERM", "EACCES", "ENOSYS", *fine):
        print("refused:", what, name)
    else:
        print("BROKEN:", what, result, name)
    return result


def number_of(name):
    """The number of a system call on this machine."""
    import platform

    table = {
        "x86_64": dict(
            ptrace=101,
            fork=57,
            clone3=435,
            clone=56,
            vfork=58,
            unshare=272,
            setns=308,
            mount=165,
            umount2=166,
            chroot=161,
            pivot_root=155,
            sethostname=170,
            reboot=169,
            swapoff=168,
            init_module=175,
            kexec_load=246,
            settimeofday=164,
            clock_settime=227,
            adjtimex=159,
            syslog=103,
            acct=163,
            bpf=321,
            perf_event_open=298,
            userfaultfd=323,
            keyctl=250,
            add_key=248,
            io_uring_setup=425,
            memfd_create=319,
            shmget=29,
            process_vm_readv=310,
            process_vm_writev=311,
            pidfd_open=434,
            pidfd_getfd=438,
            kill=62,
            tgkill=234,
            open_by_handle_at=304,
            personality=135,
            setuid=105,
            capset=126,
            mknod=133,
            mincore=27,
            madvise=28,
            sysinfo=99,
        ),
        "aarch64": dict(
            ptrace=117,
            clone3=435,
            clone=220,
            unshare=97,
            setns=268,
            mount=40,
            umount2=39,
            chroot=51,
            pivot_root=41,
            sethostname=161,
            reboot=142,
            swapoff=225,
            init_module=105,
            kexec_load=104,
            settimeofday=170,
            clock_settime=112,
            adjtimex=171,
            syslog=116,
            acct=89,
            bpf=280,
            perf_event_open=241,
            userfaultfd=282,
            keyctl=219,
            add_key=217,
            io_uring_setup=425,
            memfd_create=279,
            shmget=194,
            process_vm_readv=270,
            process_vm_writev=271,
            pidfd_open=434,
            pidfd_getfd=438,
            kill=129,
            tgkill=131,
            open_by_handle_at=265,
            personality=92,
            setuid=146,
            capset=91,
            mincore=232,
            madvise=233,
            sysinfo=179,
        ),
    }
    return table[platform.machine()].get(name, -1)
