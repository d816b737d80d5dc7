#: about = "time"
#: tries = "to run one operation that takes minutes, during which no Python handler can run"
#: holds = "the time limit for a step; signals end it from outside"
#: tick = 10
#: ends = "step_timeout at 10"

import arena

arena.drive(10)
str(7**20_000_000 % 10**15_000_000**1)
arena.play_on()
