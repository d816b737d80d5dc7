#: about = "memory and files"
#: tries = "to break the clean-up at the end of the match with 150 nested folders in a write-protected one"
#: holds = "the clean-up changes the permissions, and needs no recursion"
#: platforms = ["linux", "darwin"]
#: tick = 10
#: ends = "plays on"
#: said = ["plays on"]
#: variant = true

import contextlib
import os

import arena

arena.drive(10)
top = os.getcwd()
for _ in range(150):
    os.mkdir("d")
    os.chdir("d")
open("rcj-hostile", "w").close()
for _ in range(150):
    os.chdir("..")
with contextlib.suppress(OSError):
    os.chmod("d", 0o500)
os.chdir(top)
arena.play_on()
