#: about = "memory and files"
#: tries = "to read and change the match record, which it finds through the link of its own output"
#: holds = "the record is invisible"
#: layers = ["filesystem"]
#: platforms = ["linux"]
#: tick = 10
#: ends = "plays on"
#: succeeds_without = true
#: said = ["refused: list", "refused: result", "refused: own log again"]

import os

import arena

arena.drive(10)
try:
    log = os.readlink("/proc/self/fd/1")
except OSError as error:
    print("refused: link", error.errno)
    log = "../../../runs/logs/Y1.log"
record = os.path.dirname(os.path.dirname(log))
arena.refused("list", os.listdir, record)
arena.refused("result", open, os.path.join(record, "result.json"), "r+")
arena.refused("own log again", open, "/proc/self/fd/1", "rb")
arena.play_on()
