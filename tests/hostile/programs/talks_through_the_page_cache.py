#: about = "processes and system"
#: tries = "to send bits to another program by choosing which pages of a shared file are in memory"
#: holds = "calls that show or drop such pages are refused or have no effect"
#: platforms = ["linux"]
#: layers = ["system_calls"]
#: tick = 10
#: ends = "plays on"
#: succeeds_without = true
#: said = ["refused: mincore", "refused: read without waiting", "refused: MADV_COLD", "refused: MADV_PAGEOUT"]

import ctypes
import os

import arena

MADV_COLD, MADV_PAGEOUT = 20, 21
PAGE = 4096

arena.drive(10)
shared = os.open(os.__file__, os.O_RDONLY)
os.read(shared, 1)
libc = arena.libc()
libc.mmap.restype = ctypes.c_void_p
libc.mmap.argtypes = [ctypes.c_void_p, ctypes.c_size_t, *[ctypes.c_int] * 3, ctypes.c_long]
READ, PRIVATE = 1, 2
page = ctypes.c_void_p(libc.mmap(None, PAGE, READ, PRIVATE, shared, 0))

arena.syscall("mincore", arena.number_of("mincore"), page, PAGE, ctypes.byref(ctypes.create_string_buffer(1)))
arena.refused("read without waiting", os.preadv, shared, [bytearray(1)], 0, os.RWF_NOWAIT)
arena.syscall("MADV_COLD", arena.number_of("madvise"), page, PAGE, MADV_COLD, fine=("EINVAL",))
arena.syscall("MADV_PAGEOUT", arena.number_of("madvise"), page, PAGE, MADV_PAGEOUT, fine=("EINVAL",))
os.posix_fadvise(shared, 0, 0, os.POSIX_FADV_DONTNEED)
arena.play_on()
