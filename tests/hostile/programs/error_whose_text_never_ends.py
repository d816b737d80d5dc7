#: about = "time"
#: tries = "to hang the report of its own error with a __str__ that loops"
#: holds = "the time limit for a step"
#: tick = 10
#: ends = "step_timeout at 10"

import arena


class Endless(Exception):
    def __str__(self):
        while True:
            pass


arena.drive(10)
raise Endless
