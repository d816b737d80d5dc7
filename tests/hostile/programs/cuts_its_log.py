#: about = "output"
#: tries = "to destroy its log, and to move the position at which the match writes next by a terabyte"
#: holds = "a program has no access to its log: the match writes to it"
#: platforms = ["linux", "darwin"]
#: tick = 10
#: ends = "plays on"
#: said = ["^--- half 1: robot", "this stays", "this too"]

import fcntl
import os

import arena

arena.drive(10)
print("this stays")
for _ in range(20):
    arena.robot.step(32)
fcntl.fcntl(1, fcntl.F_SETFL, os.O_APPEND)
fcntl.fcntl(1, fcntl.F_SETFL, 0)
os.ftruncate(1, 0)
try:
    os.lseek(1, 10**12, os.SEEK_SET)
    os.write(1, b"x")
except OSError:
    pass
os.ftruncate(1, 0)
os.lseek(1, 0, os.SEEK_SET)
for _ in range(20):
    arena.robot.step(32)
print("this too")
arena.play_on()
