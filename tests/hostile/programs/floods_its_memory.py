#: about = "memory and files"
#: tries = "to take all available memory, and to catch the MemoryError"
#: holds = "a limit on its address space"
#: platforms = ["linux", "win32"]
#: layers = ["resource_limits"]
#: tick = 10
#: ends = "memory at 10"
#: limits = {memory_mb = 160}

import arena

arena.drive(10)
heap = []
for size in (1 << 24, 1 << 20):
    try:
        while True:
            heap.append(bytearray(size))
    except MemoryError:
        print("once more")
while True:
    heap.append(bytearray(1 << 16))
