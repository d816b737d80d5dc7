#: about = "processes and system"
#: tries = "to start hundreds of threads that never end"
#: holds = "a limit on its threads"
#: platforms = ["linux"]
#: layers = ["resource_limits"]
#: tick = 10
#: ends = "plays on"
#: limits = {memory_mb = 160}
#: said = ["refused: threads"]

import threading

import arena


def start():
    for _ in range(300):
        threading.Thread(target=threading.Event().wait).start()


arena.drive(10)
arena.refused("threads", start)
arena.play_on()
