#: about = "time"
#: tries = "to loop for ever in __del__"
#: holds = "the time limit for a step"
#: tick = 10
#: ends = "step_timeout at 10"
#: said = ["in __del__"]
#: variant = true

import arena


class Immortal:
    def __del__(self):
        while True:
            pass


arena.drive(10)
Immortal()
arena.play_on()
