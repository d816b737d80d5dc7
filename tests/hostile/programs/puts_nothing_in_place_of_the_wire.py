#: about = "protocol"
#: tries = "to replace its connection with /dev/null"
#: holds = "a program without its connection is ended"
#: tick = 10
#: ends = "protocol at 10"
#: cause = "closed its connection"
#: variant = true

import os

import arena
from controller import _connection

arena.drive(10)
wire = _connection.connected()._wire
nothing = os.open(os.devnull, os.O_RDWR)
os.dup2(nothing, wire._write_fd)
arena.play_on()
