#: about = "protocol"
#: tries = "to send messages without end"
#: holds = "the match accepts one message per tick; the next one is out of order"
#: tick = 10
#: ends = "protocol at 11"
#: cause = "answers tick 10 at tick 11"


import arena
from controller import _connection, _wire

arena.drive(10)
wire = _connection.connected()._wire
frame = _wire.request_frame(10, 1, 0, 0, [(0, 0.0, float("inf")), (1, 0.0, float("inf"))]) * 1000
while True:
    wire.send(frame)
