#: about = "protocol"
#: tries = "to keep the match waiting for the second half of a message"
#: holds = "the time limit for a step"
#: tick = 10
#: ends = "step_timeout at 10"
#: cause = "more than 0.5 s for one step"

import os

import arena
from controller import _connection, _wire

arena.drive(10)
wire = _connection.connected()._wire
os.write(wire._write_fd, _wire.request_frame(10, 1, 0, 0, [])[:11])
while True:
    pass
