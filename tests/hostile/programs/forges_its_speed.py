#: about = "protocol"
#: tries = "to set a speed of NaN, by bypassing the controller module"
#: holds = "the match checks all numbers"
#: tick = 10
#: ends = "protocol at 10"
#: cause = "a velocity of nan"


import arena
from controller import _connection, _wire

arena.drive(10)
wire = _connection.connected()._wire
wire.send(_wire.request_frame(10, 1, 0, 0, [(0, float("nan"), float("inf"))]))
arena.play_on()
