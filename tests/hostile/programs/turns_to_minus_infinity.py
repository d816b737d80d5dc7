#: about = "protocol"
#: tries = "a position of minus infinity, and one of NaN, past its own module"
#: holds = "numbers are judged by the match"
#: tick = 10
#: ends = "protocol at 10"
#: cause = "a position of (-inf|nan) rad"
#: variant = true


import arena
from controller import _connection, _wire

arena.drive(10)
wire = _connection.connected()._wire
wire.send(_wire.motors_frame(10, 1, 0, 0, [(0, 0.0, -float("inf")), (1, 0.0, float("nan"))]))
arena.play_on()
