#: about = "protocol"
#: tries = "to make the match queue observations: it fills its own pipe, answers in advance and reads nothing"
#: holds = "the match queues nothing for a program that does not read"
#: platforms = ["linux"]
#: tick = 10
#: ends = "plays on"
#: said = ["full", "deaf"]

import os

import arena
from controller import _connection, _wire

arena.drive(10)
wire = _connection.connected()._wire
other_end = os.open(f"/proc/self/fd/{wire._read_fd}", os.O_WRONLY | os.O_NONBLOCK)
try:
    while True:
        os.write(other_end, bytes(4096))
except BlockingIOError:
    print("full")
stop = [(0, 0.0, float("inf")), (1, 0.0, float("inf"))]
for tick in range(10, 200):
    wire.send(_wire.request_frame(tick, 1, 0, 0, stop))
print("deaf", flush=True)
while True:
    pass
