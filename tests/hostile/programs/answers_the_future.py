#: about = "protocol"
#: tries = "to answer a tick that has not begun"
#: holds = "every answer has to name the tick that it answers"
#: tick = 10
#: ends = "protocol at 10"
#: cause = "answers tick 40 at tick 10"


import arena
from controller import _connection, _wire

arena.drive(10)
wire = _connection.connected()._wire
wire.send(_wire.request_frame(40, 1, 0, 0, []))
arena.play_on()
