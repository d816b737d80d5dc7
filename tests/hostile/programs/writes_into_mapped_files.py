#: about = "memory and files"
#: tries = "to fill the disk with deleted and closed files of which it keeps one page mapped into memory"
#: holds = "mapped files without a name are counted too"
#: platforms = ["linux"]
#: tick = 10
#: ends = "output_flood at 10"
#: limits = {output_mb = 0.2, scratch_mb = 2.0}
#: cause = "wrote more than 2 MB"

import ctypes
import os

import arena

arena.drive(10)
libc = arena.libc()
libc.mmap.restype = ctypes.c_void_p
libc.mmap.argtypes = [ctypes.c_void_p, ctypes.c_size_t, *[ctypes.c_int] * 3, ctypes.c_long]
READ, PRIVATE = 1, 2
for number in range(5):
    with open("rcj-hostile", "wb+", buffering=0) as file:
        os.unlink("rcj-hostile")
        file.write(bytes(1_000_000))
        assert libc.mmap(None, 4096, READ, PRIVATE, file.fileno(), 0) != ctypes.c_void_p(-1).value
while True:
    pass
