#: about = "time"
#: tries = "to loop for ever between two steps"
#: holds = "the time limit for a step; its log shows where it hung"
#: tick = 10
#: ends = "step_timeout at 10"
#: cause = "more than 0.5 s for one step"
#: said = ["innermost call first", "in hang"]

import arena


def hang():
    while True:
        pass


arena.drive(10)
hang()
