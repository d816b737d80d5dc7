#: about = "endings"
#: tries = "to break its interpreter by writing to address 1 with ctypes"
#: holds = "each program has its own process; its log shows the line"
#: platforms = ["linux", "darwin"]
#: tick = 10
#: ends = "crash at 10"
#: cause = "SIGSEGV"
#: said = ["innermost call first", "in wreck"]

import ctypes

import arena


def wreck():
    ctypes.memset(1, 0, 100)


arena.drive(10)
wreck()
