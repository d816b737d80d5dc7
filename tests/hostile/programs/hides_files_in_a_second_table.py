#: about = "memory and files"
#: tries = "to hide deleted files in a second table of open files, made with close_range and clone"
#: holds = "all threads share one table; calls that would copy it are refused"
#: platforms = ["linux"]
#: layers = ["system_calls"]
#: tick = 10
#: ends = "plays on"
#: succeeds_without = true
#: said = ["refused: a copy by close_range", "refused: a thread without CLONE_FILES"]

import ctypes
import threading

import arena

CLOSE_RANGE = 436
CLOSE_RANGE_UNSHARE = 2
CLONE_VM, CLONE_FS, CLONE_SIGHAND, CLONE_THREAD = 0x100, 0x200, 0x800, 0x10000


def unshare():
    arena.syscall("a copy by close_range", CLOSE_RANGE, 1000, 1000, CLOSE_RANGE_UNSHARE)


def start_a_thread_with_a_copy():
    """Start a thread that waits for ever and keeps all files open that are open now."""
    libc = arena.libc()
    libc.clone.argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int, ctypes.c_void_p]
    stack = ctypes.create_string_buffer(1 << 16)
    top = ctypes.addressof(stack) + (1 << 16) - 64
    kept.append(stack)
    if libc.clone(libc.pause, top & ~15, CLONE_VM | CLONE_FS | CLONE_SIGHAND | CLONE_THREAD, None) == -1:
        raise OSError(ctypes.get_errno(), "clone")


kept = []
arena.drive(10)
thread = threading.Thread(target=unshare)
thread.start()
thread.join()
arena.refused("a thread without CLONE_FILES", start_a_thread_with_a_copy)
arena.play_on()
