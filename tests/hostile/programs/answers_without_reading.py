#: about = "protocol"
#: tries = "to answer all ticks in advance and never read observations"
#: holds = "it gains nothing, because it acts without knowledge; unread observations stay in its pipe, whose size is limited"
#: tick = 10
#: ends = "exit at 50"
#: cause = "came to its end"

import struct

import arena
from controller import _connection, _wire

arena.drive(10)
wire = _connection.connected()._wire
stop = [(0, 0.0, float("inf")), (1, 0.0, float("inf"))]
for tick in range(10, 50):
    wire.send(_wire.request_frame(tick, 1, 0, 0, stop))
while _connection.connected().tick < 50:
    frame = wire.receive()
    _connection.connected().tick = struct.unpack_from("<IBI", frame)[2]
