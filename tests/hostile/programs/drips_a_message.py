#: about = "protocol"
#: tries = "to keep the match busy with a message that arrives byte by byte"
#: holds = "the time limit for a step covers the whole message"
#: tick = 10
#: ends = "step_timeout at 10"
#: cause = "more than 0.5 s for one step"
#: variant = true

import os
import struct

import arena
from controller import _connection

arena.drive(10)
wire = _connection.connected()._wire
import threading

lock = threading.Lock()
lock.acquire()
frame = struct.pack("<I", 1000) + bytes(1000)
for byte in frame:
    os.write(wire._write_fd, bytes([byte]))
    lock.acquire(timeout=0.01)
