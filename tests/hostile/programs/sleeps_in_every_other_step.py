#: about = "time"
#: tries = "to make the match wait as long as possible, by alternating computation and real sleep, also within a step"
#: holds = "CPU time and idle time are charged together"
#: tick = 10
#: ends = "half_timeout"
#: limits = {half_s = 1.0}
#: cause = "more than 1 s for all its steps"
#: platforms = ["linux"]
#: variant = true

import hashlib
import itertools

import arena

arena.drive(10)
for turn in itertools.count():
    arena.robot.step(32)
    if turn % 3 != 1:
        arena.libc().usleep(100_000)
    if turn % 3 != 0:
        for _ in range(50):
            hashlib.sha256(bytes(1_000_000))
