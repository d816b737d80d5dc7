#: about = "processes and system"
#: tries = "to send signals to the match, to all processes and to its group (signal 0, which only tests whether this is allowed)"
#: holds = "it can signal only itself"
#: layers = ["system_calls"]
#: platforms = ["linux"]
#: tick = 10
#: ends = "plays on"
#: succeeds_without = true
#: said = ["refused: the match", "refused: init", "refused: everybody"]

import os
import signal

import arena

arena.drive(10)
match = os.getppid()
arena.refused("the match", os.kill, match, 0)
arena.refused("init", os.kill, 1, 0)
arena.refused("everybody", os.kill, -1, 0)
arena.refused("group of the match", lambda: os.killpg(os.getpgid(match), 0))
arena.refused("thread of the match", lambda: signal.pidfd_send_signal(os.pidfd_open(match), 0))
arena.syscall("tgkill", arena.number_of("tgkill"), match, match, 0)
arena.play_on()
