#: about = "endings"
#: tries = "to exit with os._exit(0) while it is being imported"
#: holds = "it counts as an exit at tick 0"
#: tick = 0
#: ends = "exit at 0"
#: cause = "exit status 0"

import os

os._exit(0)
