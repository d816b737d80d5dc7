#: about = "protocol"
#: tries = "to send a message that announces more than it contains"
#: holds = "any violation of the protocol ends it"
#: tick = 10
#: ends = "protocol at 10"
#: cause = "too many settings"
#: variant = true

import struct

import arena
from controller import _connection

arena.drive(10)
wire = _connection.connected()._wire
body = struct.pack("<BIIIQHHHHI", 0x52, 10, 1, 0, 0, 60000, 60000, 60000, 60000, 2**32 - 1) + bytes(100)
wire.send(struct.pack("<I", len(body)) + body)
arena.play_on()
