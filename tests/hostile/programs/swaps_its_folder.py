#: about = "memory and files"
#: tries = "to replace its own folder with a link, so that the match counts, changes or deletes what the link points to"
#: holds = "the folder that contains its own cannot be changed"
#: layers = ["filesystem"]
#: platforms = ["linux"]
#: tick = 10
#: ends = "plays on"
#: succeeds_without = true
#: said = ["refused: rename", "refused: link"]

import os

import arena

arena.drive(10)
home = os.environ["HOME"]
treasure = os.path.join(os.path.dirname(home), "..", "..", "treasure")
arena.refused("rename", os.rename, home, home + "-moved")
arena.refused("link", os.symlink, treasure, home + "-link")
if os.path.islink(home + "-link"):
    os.unlink(home + "-link")
if os.path.exists(home + "-moved"):
    os.rename(home + "-moved", home)
arena.play_on()
