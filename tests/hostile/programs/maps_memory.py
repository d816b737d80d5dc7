#: about = "memory and files"
#: tries = "to take memory without Python's allocator: anonymous and shared mappings"
#: holds = "a limit on its address space"
#: platforms = ["linux"]
#: layers = ["resource_limits"]
#: tick = 10
#: ends = "plays on"
#: limits = {memory_mb = 160}
#: said = ["refused: private", "refused: shared"]

import mmap

import arena


def take(flags):
    return [mmap.mmap(-1, 1 << 24, flags=flags) for _ in range(20)]


arena.drive(10)
arena.refused("private", take, mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS)
arena.refused("shared", take, mmap.MAP_SHARED | mmap.MAP_ANONYMOUS)
arena.play_on()
