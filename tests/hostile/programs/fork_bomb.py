#: about = "processes and system"
#: tries = "to start copies of itself without end"
#: holds = "starting a process is refused"
#: layers = ["system_calls"]
#: platforms = ["linux"]
#: tick = 10
#: ends = "plays on"
#: succeeds_without = true
#: said = ["refused: fork", "refused: forkpty"]
#: variant = true

import os

import arena


def one(fork):
    child = fork()
    if child == 0:
        os._exit(0)  # a real one would not
    os.waitpid(child, 0)
    return child


def bomb():
    for _ in range(20):
        one(os.fork)


arena.drive(10)
arena.refused("fork", bomb)
arena.refused("forkpty", lambda: one(lambda: os.forkpty()[0]))
arena.play_on()
