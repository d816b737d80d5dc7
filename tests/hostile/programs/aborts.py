#: about = "endings"
#: tries = "to end itself with the signal by which the match asks where it hangs"
#: holds = "a process ended by a signal has crashed"
#: platforms = ["linux", "darwin"]
#: tick = 10
#: ends = "crash at 10"
#: cause = "SIGABRT"

import os

import arena

arena.drive(10)
os.abort()
