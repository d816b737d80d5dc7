#: about = "time"
#: tries = "to loop for ever between two steps"
#: holds = "the wall limit of a step; its log shows where it hung"
#: tick = 10
#: ends = "step_timeout at 10"
#: cause = "did not call step for 0.5 s"
#: said = ["innermost call first", "in hang"]

import arena


def hang():
    while True:
        pass


arena.drive(10)
hang()
