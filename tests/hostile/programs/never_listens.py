#: about = "protocol"
#: tries = "to have the match keep what it is told: it answers in advance and reads nothing"
#: holds = "what a program does not take is not kept for it"
#: platforms = ["linux"]
#: tick = 10
#: ends = "plays on"
#: said = ["deaf"]

import fcntl

import arena
from controller import _hub, _wire

arena.drive(10)
wire = _hub.connected()._wire


fcntl.fcntl(wire._read_fd, 1031, 4096)  # F_SETPIPE_SZ: the smallest pipe there is
stop = [(0, 0.0, float("inf")), (1, 0.0, float("inf"))]
for tick in range(10, 200):
    wire.send(_wire.motors_frame(tick, 1, 0, 0, stop))
print("deaf", flush=True)
while True:
    pass
