#: about = "output"
#: tries = "to fill the disk through the file descriptors of its output"
#: holds = "the size of the log is checked, and no file can grow beyond a limit"
#: tick = 10
#: ends = "output_flood at 10"
#: limits = {output_mb = 0.2, scratch_mb = 2.0}

import os

import arena

arena.drive(10)
while True:
    for fd in (1, 2):
        try:
            os.write(fd, b"flood " * 1000)
        except OSError:
            pass
