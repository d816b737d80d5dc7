#: about = "protocol"
#: tries = "to take leave with terminal escapes and a traceback of megabytes, and to play on"
#: holds = "after its farewell it is ended; the text is made harmless"
#: tick = 10
#: ends = "crash at 10"
#: cause = "^(?!.*[\\x00-\\x1f]).*bye"

import struct

import arena
from controller import _connection

arena.drive(10)
wire = _connection.connected()._wire
told = b"\x1b[2Jbye\xff\xfe\r\n\x1b]0;x\x07"
trace = b"\x1b[31mline\n" * 150_000
wire.send(struct.pack("<IBBI", 6 + len(told) + len(trace), 0x46, 0, len(told)) + told + trace)
arena.play_on()
