#: about = "memory and files"
#: tries = "to make the match count, change or delete other files, through links out of its folder"
#: holds = "links are counted and removed as links, never followed"
#: platforms = ["linux", "darwin"]
#: tick = 10
#: ends = "plays on"
#: limits = {output_mb = 0.2, scratch_mb = 2.0}
#: said = ["plays on"]

import os
import shutil

import arena

arena.drive(10)
home = os.environ["HOME"]
treasure = os.path.abspath(os.path.join(home, "..", "..", "..", "treasure"))
os.symlink("/usr", os.path.join(home, "usr"))
os.symlink("/", "root")
os.symlink(".", "circle")
os.symlink(treasure, "treasure")
os.symlink("nowhere", "rcj-hostile-nowhere")
os.chdir(home)
shutil.rmtree("controllers")
os.symlink(treasure, "controllers")
try:
    os.link(os.path.join(treasure, "keep.txt"), "hard")
except OSError as error:
    print("refused: hard link", error.errno)
arena.play_on()
