#: about = "memory and files"
#: tries = "to break the clean-up with 1200 nested folders, whose path is longer than any call accepts"
#: holds = "counting and cleaning up need neither recursion nor long paths"
#: platforms = ["linux", "darwin"]
#: tick = 10
#: ends = "output_flood at 10"
#: limits = {output_mb = 0.2, scratch_mb = 2.0}

import os

import arena

arena.drive(10)
for number in range(1200):
    os.mkdir("rcj-hostile" if number % 2 else "d")
    os.chdir("rcj-hostile" if number % 2 else "d")
arena.hang()
