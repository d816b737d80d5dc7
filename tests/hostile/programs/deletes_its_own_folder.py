#: about = "memory and files"
#: tries = "to delete its own files, folder and home, so that the current folder no longer exists"
#: holds = "the folder is its own copy; the match does not need it"
#: platforms = ["linux", "darwin"]
#: tick = 10
#: ends = "plays on"
#: said = ["gone: "]
#: variant = true

import os
import shutil

import arena

arena.drive(10)
shutil.rmtree(os.environ["HOME"], ignore_errors=True)
print("gone:", os.listdir(os.environ["HOME"]) if os.path.isdir(os.environ["HOME"]) else "wholly")
arena.play_on()
