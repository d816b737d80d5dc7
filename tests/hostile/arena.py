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

    table = dict(  # x86_64, aarch64
        ptrace=(101, 117), fork=(57, -1), clone3=(435, 435), clone=(56, 220), vfork=(58, -1), unshare=(272, 97),
        setns=(308, 268), mount=(165, 40), umount2=(166, 39), chroot=(161, 51), pivot_root=(155, 41),
        sethostname=(170, 161), reboot=(169, 142), swapoff=(168, 225), init_module=(175, 105), kexec_load=(246, 104),
        settimeofday=(164, 170), clock_settime=(227, 112), adjtimex=(159, 171), syslog=(103, 116), acct=(163, 89),
        bpf=(321, 280), perf_event_open=(298, 241), userfaultfd=(323, 282), keyctl=(250, 219), add_key=(248, 217),
        io_uring_setup=(425, 425), memfd_create=(319, 279), shmget=(29, 194), process_vm_readv=(310, 270),
        process_vm_writev=(311, 271), pidfd_open=(434, 434), pidfd_getfd=(438, 438), kill=(62, 129),
        tgkill=(234, 131), open_by_handle_at=(304, 265), personality=(135, 92), setuid=(105, 146), capset=(126, 91),
        mknod=(133, -1), mincore=(27, 232), madvise=(28, 233), sysinfo=(99, 179),
    )
    return table.get(name, (-1, -1))[platform.machine() == "aarch64"]
