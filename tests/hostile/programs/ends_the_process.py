#: about = "endings"
#: tries = "to vanish with os._exit in the middle of a line of output"
#: holds = "it counts as an exit, reported with its status"
#: tick = 10
#: ends = "exit at 10"
#: cause = "exit status 77"

import os
import sys

import arena

arena.drive(10)
sys.stdout.write("half a li")
os._exit(77)
