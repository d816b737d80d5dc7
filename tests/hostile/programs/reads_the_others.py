#: about = "memory and files"
#: tries = "to read the code of the other team, in the folders of their programs"
#: holds = "only its own folder can be seen"
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
