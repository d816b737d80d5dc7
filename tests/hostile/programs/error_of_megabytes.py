#: about = "endings"
#: tries = "to flood the log and the result with the text of its error"
#: holds = "the text of a fault is cut off at 1000 characters, its traceback at 20 kB"
#: tick = 10
#: ends = "crash at 10"
#: cause = "^ValueError: xxx.{0,1000}$"

import arena

arena.drive(10)
raise ValueError("x" * 3_000_000)
