#: about = "memory and files"
#: tries = "to fill the disk with files in its own folder"
#: holds = "its folder has a size limit, which is checked while the match waits"
#: tick = 10
#: ends = "output_flood at 10"
#: limits = {output_mb = 0.2, scratch_mb = 2.0}
#: cause = "wrote more than 2 MB"

import arena

arena.drive(10)
number = 0
while True:
    number += 1
    with open(f"rcj-hostile-{number % 100}", "wb") as file:
        file.write(bytes(100_000))
