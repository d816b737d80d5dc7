#: about = "output"
#: tries = "to fill the disk with its output, and to catch the exception that stops it"
#: holds = "output is counted; beyond the limit, the program is ended"
#: tick = 10
#: ends = "output_flood at 10"
#: limits = {output_mb = 0.2, scratch_mb = 2.0}
#: cause = "printed more than 0.2 MB"

import arena

arena.drive(10)
while True:
    try:
        print("flood " * 1000)
    except BaseException:
        pass
