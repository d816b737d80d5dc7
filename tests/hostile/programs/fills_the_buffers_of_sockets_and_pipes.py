#: about = "memory and files"
#: tries = "to hold gigabytes in the buffers of socket pairs and pipes, which the memory limit does not cover"
#: holds = "buffers cannot be enlarged, and the limit on open files bounds their number"
#: platforms = ["linux"]
#: layers = ["system_calls", "resource_limits"]
#: tick = 10
#: ends = "plays on"
#: succeeds_without = true
#: said = ["refused: a larger buffer", "refused: a larger pipe", "all buffers hold [0-9]{1,2} MB"]

import fcntl
import os
import socket

import arena

LARGE_BYTES, MAX_PAIRS = 1 << 20, 125
F_SETPIPE_SZ = 1031


def fill(fd):
    """Return how many bytes fit in."""
    os.set_blocking(fd, False)
    taken = 0
    while True:
        try:
            taken += os.write(fd, bytes(1 << 16))
        except BlockingIOError:
            return taken


arena.drive(10)
left, right = socket.socketpair()
arena.refused("a larger buffer", left.setsockopt, socket.SOL_SOCKET, socket.SO_SNDBUF, LARGE_BYTES)
read, write = os.pipe()
arena.refused("a larger pipe", fcntl.fcntl, write, F_SETPIPE_SZ, LARGE_BYTES)

pairs = [(left, right)]
try:
    while len(pairs) < MAX_PAIRS:
        pairs.append(socket.socketpair())
except OSError as error:
    print("no more pairs:", error)
held = sum(fill(end.fileno()) for pair in pairs for end in pair)
print("all buffers hold", held // 1_000_000, "MB")
for pair in pairs:
    for end in pair:
        end.close()
arena.play_on()
