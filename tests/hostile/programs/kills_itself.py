#: about = "endings"
#: tries = "to kill itself"
#: holds = "a program ended by a signal counts as crashed"
#: platforms = ["linux", "darwin"]
#: tick = 10
#: ends = "crash at 10"
#: cause = "SIGKILL"
#: variant = true

import os
import signal

import arena

arena.drive(10)
os.kill(os.getpid(), signal.SIGKILL)
