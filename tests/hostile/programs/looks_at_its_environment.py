#: about = "memory and files"
#: tries = "to find passwords and paths in the environment that it inherits"
#: holds = "it inherits nothing: its environment is a short fixed list"
#: tick = 10
#: ends = "plays on"
#: said = ["nothing of interest"]

import os

import arena

arena.drive(10)
for name, value in os.environ.items():
    told = name if name in ("HOME", "TMPDIR", "TEMP", "TMP", "USERPROFILE", "APPDATA", "WEBOTS_HOME") else name + value
    if any(word in told.lower() for word in ("secret", "token", "pytest", "xdist", "virtual_env")):
        print("BROKEN:", name)
print("nothing of interest")
arena.play_on()
