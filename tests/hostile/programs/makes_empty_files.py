#: about = "memory and files"
#: tries = "to use up the disk's inodes with hundreds of empty files and folders"
#: holds = "every file and folder counts as one block"
#: tick = 10
#: ends = "output_flood at 10"
#: limits = {output_mb = 0.2, scratch_mb = 2.0}
#: cause = "wrote more than 2 MB"

import os

import arena

arena.drive(10)
for number in range(700):
    open(f"rcj-hostile-{number}", "wb").close()
    os.mkdir(f"rcj-hostile-folder-{number}")
arena.hang()
