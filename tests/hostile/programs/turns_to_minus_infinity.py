#: about = "protocol"
#: tries = "to set a position of minus infinity, and one of NaN, by bypassing the controller module"
#: holds = "the match checks all numbers"
#: tick = 10
#: ends = "protocol at 10"
#: cause = "a position of (-inf|nan)"
#: variant = true


import arena
from controller import _connection, _wire

arena.drive(10)
wire = _connection.connected()._wire
wire.send(_wire.request_frame(10, 1, 0, 0, [(0, 0.0, -float("inf")), (1, 0.0, float("nan"))]))
arena.play_on()
