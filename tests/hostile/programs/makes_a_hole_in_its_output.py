#: about = "output"
#: tries = "to make the match read gigabytes of zeros through a gap in its output"
#: holds = "no more of its output is read than it may print"
#: platforms = ["linux", "darwin"]
#: tick = 10
#: ends = "output_flood at 10"
#: limits = {output_mb = 0.2, scratch_mb = 2.0}
#: variant = true

import os

import arena

arena.drive(10)
os.ftruncate(1, 2_000_000)
arena.hang()
