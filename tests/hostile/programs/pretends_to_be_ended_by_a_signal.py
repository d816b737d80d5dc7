#: about = "endings"
#: tries = "to exit with statuses that mean something else"
#: holds = "whatever its status, it has ended"
#: tick = 10
#: ends = "crash|exit at 10"
#: variant = true

import os

import arena

arena.drive(10)
os._exit(128 + 9)
