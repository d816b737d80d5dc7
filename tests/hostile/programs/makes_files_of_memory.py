#: about = "memory and files"
#: tries = "to hide gigabytes in memory that belongs to no process: memfd, System V and POSIX shared memory"
#: holds = "these calls are refused, and /dev/shm is invisible"
#: platforms = ["linux"]
#: layers = ["system_calls", "filesystem"]
#: tick = 10
#: ends = "plays on"
#: succeeds_without = true
#: said = ["refused: memfd", "refused: shmget", "refused: /dev/shm"]

import os

import arena


def share():
    path = "/dev/shm/rcj-hostile-shared"
    with open(path, "wb") as file:
        file.write(b"x")
    os.unlink(path)


arena.drive(10)
arena.syscall("memfd", arena.number_of("memfd_create"), b"x", 0)
shared = arena.syscall("shmget", arena.number_of("shmget"), 0, 4096, 0o1600)
if shared >= 0:
    arena.libc().shmctl(shared, 0, None)
arena.refused("/dev/shm", share)
arena.play_on()
