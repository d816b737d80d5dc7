#: about = "protocol"
#: tries = "to close all its descriptors and keep running"
#: holds = "a program without its connection is ended"
#: tick = 10
#: ends = "protocol|exit at 10"
#: cause = "closed its connection|exit status 1"

import os

import arena
from controller import _connection

arena.drive(10)
wire = _connection.connected()._wire
import threading

os.closerange(0, 300)
threading.Event().wait()
