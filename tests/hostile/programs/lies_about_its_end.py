#: about = "protocol"
#: tries = "a farewell full of terminal escapes, of a kind that does not exist"
#: holds = "what is not exactly as the protocol demands ends it"
#: tick = 10
#: ends = "protocol at 10"
#: cause = "a farewell that is none"
#: variant = true

import struct

import arena
from controller import _connection

arena.drive(10)
wire = _connection.connected()._wire
told = b"\x1b[2J\xff\xfe\r\n" * 100
wire.send(struct.pack("<IBBI", 6 + len(told), 0x46, 200, len(told)) + told)
arena.play_on()
