#: about = "protocol"
#: tries = "to drive at ten times the highest speed, by bypassing the controller module"
#: holds = "the match checks all numbers"
#: tick = 10
#: ends = "protocol at 10"
#: cause = "a velocity of 100"
#: variant = true


import arena
from controller import _connection, _wire

arena.drive(10)
wire = _connection.connected()._wire
wire.send(_wire.request_frame(10, 1, 0, 0, [(0, 100.0, float("inf"))]))
arena.play_on()
