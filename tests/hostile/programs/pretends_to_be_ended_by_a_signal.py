#: about = "endings"
#: tries = "to exit with a status that normally means something else, such as an end by SIGKILL"
#: holds = "whatever its status, the program has ended"
#: tick = 10
#: ends = "crash|exit at 10"
#: variant = true

import os

import arena

arena.drive(10)
os._exit(128 + 9)
