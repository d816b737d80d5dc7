#: about = "processes and system"
#: tries = "to wake another program that waits for a word of a library's file, by a call and by the end of a thread"
#: holds = "no program can wait for, or wake, others: such waits return at once, and such wakes find none"
#: platforms = ["linux"]
#: layers = ["system_calls"]
#: tick = 10
#: ends = "plays on"
#: succeeds_without = true
#: said = ["no bit: wake", "no bit: futex_wake", "no bit: end of a thread"]

import _thread
import ctypes
import os
import platform

import arena

FUTEX_WAIT, FUTEX_WAKE, FUTEX2_SIZE_U32 = 0, 1, 2
PAGE, READ, SHARED = 4096, 1, 1
FUTEX, SET_TID_ADDRESS, EXIT = {"x86_64": (202, 218, 60), "aarch64": (98, 96, 93)}[platform.machine()]
FUTEX2_WAKE = 454

arena.drive(10)
libc = arena.libc()
libc.mmap.restype = ctypes.c_void_p
libc.mmap.argtypes = [ctypes.c_void_p, ctypes.c_size_t, *[ctypes.c_int] * 3, ctypes.c_long]
file = os.open(os.__file__, os.O_RDONLY)
# Two mappings, as two programs would have them.
sender, receiver = (ctypes.c_void_p(libc.mmap(None, PAGE, READ, SHARED, file, 0)) for _ in range(2))
value = ctypes.c_uint32.from_address(receiver.value)
call = libc.syscall
long = ctypes.c_long


def wait():
    """Wait for the word, for half a second of real time, and report whether something woke this thread."""
    half_a_second = (long * 2)(0, 500_000_000)
    result = call(long(FUTEX), receiver, long(FUTEX_WAIT), long(value.value), half_a_second, None, long(0))
    woken.append(result == 0)


def end_a_thread():
    """End a thread whose end the kernel announces at the word. Python knows nothing of it."""
    thread = ctypes.c_ulong()
    libc.pthread_create(ctypes.byref(thread), None, end, None)
    libc.pthread_detach(thread)


@ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_void_p)
def end(_):
    call(long(SET_TID_ADDRESS), sender)
    call(long(EXIT), long(0))


woken = []
for how, send in {
    "wake": lambda: call(long(FUTEX), sender, long(FUTEX_WAKE), long(1), None, None, long(0)),
    "futex_wake": lambda: call(long(FUTEX2_WAKE), sender, long(1), long(1), long(FUTEX2_SIZE_U32)),
    "end of a thread": end_a_thread,
}.items():
    woken.clear()
    _thread.start_new_thread(wait, ())
    while not woken:
        libc.usleep(20_000)
        send()
    print("BROKEN:" if woken[0] else "no bit:", how)
arena.play_on()
