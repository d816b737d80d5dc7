#: about = "protocol"
#: tries = "to report its end with terminal escapes and megabytes of traceback, and then to play on"
#: holds = "it is ended after this report; the text is sanitized"
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
