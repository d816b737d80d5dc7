#: about = "processes and system"
#: tries = "to lift its own limits, to change those of the match, and to raise its priority"
#: holds = "limits and priorities can no longer be changed, even by root"
#: layers = ["system_calls"]
#: platforms = ["linux"]
#: tick = 10
#: ends = "plays on"
#: said = ["refused: own limit", "refused: limit of the match", "refused: priority"]

import os
import resource

import arena

arena.drive(10)
unlimited = resource.RLIM_INFINITY
match = os.getppid()
arena.refused("own limit", resource.setrlimit, resource.RLIMIT_AS, (unlimited, unlimited))
arena.refused(
    "limit of the match",
    lambda: resource.prlimit(match, resource.RLIMIT_CORE, resource.prlimit(match, resource.RLIMIT_CORE)),
)
arena.refused("priority", os.setpriority, os.PRIO_PROCESS, 0, -5)
arena.refused(
    "priority of the match", lambda: os.setpriority(os.PRIO_PROCESS, match, os.getpriority(os.PRIO_PROCESS, match))
)
arena.refused("real time", os.sched_setscheduler, 0, os.SCHED_FIFO, os.sched_param(1))
arena.play_on()
