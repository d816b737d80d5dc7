#: about = "protocol"
#: tries = "to command motors that are not its own, by guessing numbers"
#: holds = "a pipe belongs to one robot, and device numbers refer only to that robot's devices"
#: tick = 10
#: ends = "protocol at 10"
#: cause = "device 65535 is not a motor"


import arena
from controller import _connection, _wire

arena.drive(10)
wire = _connection.connected()._wire
wire.send(_wire.request_frame(10, 1, 0, 0, [(65535, 10.0, float("inf"))]))
arena.play_on()
