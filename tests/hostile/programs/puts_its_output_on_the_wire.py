#: about = "protocol"
#: tries = "to connect its output to the protocol pipe"
#: holds = "any violation of the protocol ends it"
#: tick = 10
#: ends = "protocol at 10"
#: cause = "a message"
#: variant = true

import os

import arena
from controller import _connection

arena.drive(10)
wire = _connection.connected()._wire
os.dup2(wire._write_fd, 1)
print("forward, all of you!" * 10, flush=True)
arena.play_on()
