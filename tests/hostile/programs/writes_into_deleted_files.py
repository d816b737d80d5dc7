#: about = "memory and files"
#: tries = "to fill the disk with deleted files that it keeps open"
#: holds = "open files without a name are counted too"
#: platforms = ["linux"]
#: tick = 10
#: ends = "output_flood at 10"
#: limits = {output_mb = 0.2, scratch_mb = 2.0}
#: cause = "wrote more than 2 MB"

import os

import arena

arena.drive(10)
held = []
for number in range(5):
    file = open("rcj-hostile", "wb", buffering=0)
    os.unlink("rcj-hostile")
    file.write(bytes(1_000_000))
    held.append(file)
while True:
    pass
