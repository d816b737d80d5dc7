#: about = "protocol"
#: tries = "to send an empty message"
#: holds = "any violation of the protocol ends it"
#: tick = 10
#: ends = "protocol at 10"
#: cause = "an empty message"
#: variant = true

import os

import arena
from controller import _connection

arena.drive(10)
wire = _connection.connected()._wire
os.write(wire._write_fd, bytes(4))
arena.play_on()
