#: about = "memory and files"
#: tries = "to read the other team's code in the folders of its programs"
#: holds = "only its own folder is visible"
#: layers = ["filesystem"]
#: platforms = ["linux"]
#: tick = 10
#: ends = "plays on"
#: succeeds_without = true
#: said = ["refused: list", "refused: find"]

import glob
import os

import arena


def find():
    for name in glob.glob(os.path.join(os.path.dirname(os.environ["HOME"]), "rcj-B*", "controllers", "plan.txt")):
        return open(name).read()
    raise FileNotFoundError


arena.drive(10)
arena.refused("list", os.listdir, os.path.dirname(os.environ["HOME"]))
arena.refused("find", find)
arena.play_on()
