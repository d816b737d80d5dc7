#: about = "protocol"
#: tries = "to request a step of length 0"
#: holds = "a step lasts at least one tick"
#: tick = 10
#: ends = "protocol at 10"
#: cause = "advance by 0 ticks"
#: variant = true


import arena
from controller import _connection, _wire

arena.drive(10)
wire = _connection.connected()._wire
wire.send(_wire.request_frame(10, 0, 0, 0, []))
arena.play_on()
