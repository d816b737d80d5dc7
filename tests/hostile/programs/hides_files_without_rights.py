#: about = "memory and files"
#: tries = "to hide its files in folders without read permission"
#: holds = "a folder that cannot be read counts as too large"
#: platforms = ["linux", "darwin"]
#: tick = 10
#: ends = "output_flood at 10"
#: limits = {output_mb = 0.2, scratch_mb = 2.0}
#: cause = "wrote more than 2 MB"

import contextlib
import os

import arena

arena.drive(10)
os.makedirs("rcj-hostile/inner")
for number in range(6):
    with open(f"rcj-hostile/inner/{number}", "wb") as file:
        file.write(bytes(1_000_000))
with contextlib.suppress(OSError):
    os.chmod("rcj-hostile/inner", 0)
    os.chmod("rcj-hostile", 0)
while True:
    pass
