#: about = "protocol"
#: tries = "to send bytes that are not a message"
#: holds = "any violation of the protocol ends it"
#: tick = 10
#: ends = "protocol at 10"
#: cause = "an invalid message: a message of unknown type 120"

import os
import struct

import arena
from controller import _connection

arena.drive(10)
wire = _connection.connected()._wire
os.write(wire._write_fd, struct.pack("<I", 30) + b"x" * 30)
arena.play_on()
