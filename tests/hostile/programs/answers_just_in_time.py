#: about = "time"
#: tries = "to use almost the whole time limit in every step"
#: holds = "the time limit for a half"
#: tick = 10
#: ends = "half_timeout"
#: limits = {half_s = 1.0}
#: cause = "more than 1 s for all its steps"

import threading

import arena

arena.drive(10)
lock = threading.Lock()
lock.acquire()
while arena.robot.step(32) != -1:
    lock.acquire(timeout=0.15)
