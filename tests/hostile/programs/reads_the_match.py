#: about = "memory and files"
#: tries = "to read the environment, memory, descriptors and command line of the match that started it"
#: holds = "other processes are invisible"
#: layers = ["filesystem"]
#: platforms = ["linux"]
#: tick = 10
#: ends = "plays on"
#: succeeds_without = true
#: said = ["refused: environ", "refused: mem", "refused: fd"]

import os

import arena

arena.drive(10)
match = f"/proc/{os.getppid()}/"
for name in ("environ", "mem", "maps", "cmdline"):
    arena.refused(name, lambda: open(match + name, "rb").read(0 if name == "mem" else 10))
arena.refused("fd", os.listdir, match + "fd")
arena.refused("cwd", os.listdir, match + "cwd")
arena.play_on()
