#: about = "protocol"
#: tries = "to answer one tick twice, with other speeds the second time"
#: holds = "every answer has to name the tick that it answers"
#: tick = 10
#: ends = "protocol at 11"
#: cause = "answers tick 10 at tick 11"


import arena
from controller import _connection, _wire

arena.drive(10)
wire = _connection.connected()._wire
stop = [(0, 0.0, float("inf")), (1, 0.0, float("inf"))]
wire.send(_wire.request_frame(10, 1, 0, 0, stop) + _wire.request_frame(10, 1, 0, 0, [(0, 10.0, float("inf"))]))
arena.robot.step(32)
arena.play_on()
