#: about = "protocol"
#: tries = "to slow the match down with a message of hundreds of thousands of settings"
#: holds = "the number of settings in a message is limited"
#: tick = 10
#: ends = "protocol at 10"
#: cause = "packets in one step|too many"

import struct

import arena
from controller import _connection

arena.drive(10)
wire = _connection.connected()._wire
emission = struct.pack("<HI", 0, 0)
emitter = arena.robot.getDevice("team emitter")._rcj_index
emission = struct.pack("<HI", emitter, 0)
count = 300_000
body = struct.pack("<BIIIQHHHHI", 0x52, 10, 1, 0, 0, 0, 0, 0, 0, count) + emission * count
wire.send(struct.pack("<I", len(body)) + body)
arena.play_on()
