#: about = "processes and system"
#: tries = "to start hundreds of threads that never end"
#: holds = "a limit on the number of its threads"
#: platforms = ["linux"]
#: layers = ["resource_limits"]
#: tick = 10
#: ends = "plays on"
#: limits = {memory_mb = 160}
#: said = ["refused: threads"]

import _thread
import threading

import arena


def start():
    # Not threading.Thread: its start waits for ever for a thread that dies of hunger before it can say that it runs.
    for _ in range(300):
        _thread.start_new_thread(threading.Event().wait, ())


arena.drive(10)
arena.refused("threads", start)
arena.play_on()
