#: about = "memory and files"
#: tries = "to open files until there are no descriptors left"
#: holds = "a limit on open files"
#: platforms = ["linux", "darwin"]
#: layers = ["resource_limits"]
#: tick = 10
#: ends = "plays on"
#: said = ["refused: open"]

import os

import arena


def open_on():
    for _ in range(5000):
        os.dup(0)


arena.drive(10)
arena.refused("open", open_on)
arena.play_on()
