#: about = "protocol"
#: tries = "to report an end of an unknown kind, with terminal escapes"
#: holds = "any violation of the protocol ends it"
#: tick = 10
#: ends = "protocol at 10"
#: cause = "an invalid farewell"
#: variant = true

import struct

import arena
from controller import _connection

arena.drive(10)
wire = _connection.connected()._wire
told = b"\x1b[2J\xff\xfe\r\n" * 100
wire.send(struct.pack("<IBBI", 6 + len(told), 0x46, 200, len(told)) + told)
arena.play_on()
