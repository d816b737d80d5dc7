#: about = "time"
#: tries = "to stop itself with SIGSTOP, so that none of its handlers can run"
#: holds = "the time limit for a step, then SIGKILL"
#: platforms = ["linux", "darwin"]
#: tick = 10
#: ends = "step_timeout at 10"

import os
import signal

import arena

arena.drive(10)
os.kill(os.getpid(), signal.SIGSTOP)
arena.play_on()
