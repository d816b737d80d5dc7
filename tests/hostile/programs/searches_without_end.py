#: about = "time"
#: tries = "to evaluate a regular expression that takes longer than the age of the universe"
#: holds = "the time limit for a step"
#: tick = 10
#: ends = "step_timeout at 10"
#: variant = true

import re

import arena

arena.drive(10)
re.match("(a|a)*$", "a" * 60 + "b")
arena.play_on()
