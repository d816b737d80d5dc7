#: about = "protocol"
#: tries = "to send messages that only the match may send: hello and observations"
#: holds = "any violation of the protocol ends it"
#: tick = 10
#: ends = "protocol at 10"
#: cause = "a message of unknown type 79"

import os
import struct

import arena
from controller import _connection

arena.drive(10)
wire = _connection.connected()._wire
os.write(wire._write_fd, struct.pack("<IBIBII", 14, 0x4F, 11, 1, 0, 0))
arena.play_on()
