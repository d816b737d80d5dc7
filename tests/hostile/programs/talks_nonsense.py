#: about = "protocol"
#: tries = "to say something that is no message"
#: holds = "what is not exactly as the protocol demands ends it"
#: tick = 10
#: ends = "protocol at 10"
#: cause = "no message: a message of unknown type 120"

import os
import struct

import arena
from controller import _connection

arena.drive(10)
wire = _connection.connected()._wire
os.write(wire._write_fd, struct.pack("<I", 30) + b"x" * 30)
arena.play_on()
