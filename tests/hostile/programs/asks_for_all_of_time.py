#: about = "protocol"
#: tries = "to request a step of four billion ticks after missing just as many"
#: holds = "the match continues without it"
#: tick = 10
#: ends = "plays on"
#: said = ["asked"]
#: variant = true


import arena
from controller import _connection, _wire

arena.drive(10)
wire = _connection.connected()._wire
stop = [(0, 0.0, float("inf")), (1, 0.0, float("inf"))]
print("asked", flush=True)
wire.exchange(_wire.request_frame(10, 1, 0, 0, stop))
wire.exchange(_wire.request_frame(11, 2**32 - 1, 2**32 - 1, 2**64 - 1, stop))
