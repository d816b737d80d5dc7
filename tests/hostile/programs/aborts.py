#: about = "endings"
#: tries = "to end itself with the signal that the match uses to find out where a program hangs"
#: holds = "a program ended by a signal counts as crashed"
#: platforms = ["linux", "darwin"]
#: tick = 10
#: ends = "crash at 10"
#: cause = "SIGABRT"

import os

import arena

arena.drive(10)
os.abort()
