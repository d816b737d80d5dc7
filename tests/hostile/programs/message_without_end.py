#: about = "protocol"
#: tries = "to announce a message of 4 GB"
#: holds = "a message that is too long ends it before it is read"
#: tick = 10
#: ends = "protocol at 10"
#: cause = "a message of 4294967295 bytes"

import os

import arena
from controller import _connection

arena.drive(10)
wire = _connection.connected()._wire
os.write(wire._write_fd, b"\xff\xff\xff\xff" + bytes(60_000))
arena.play_on()
