#: about = "time"
#: tries = "to use up the wall limit of a step almost wholly, on every step"
#: holds = "the sum of all waits in a half"
#: tick = 10
#: ends = "half_timeout"
#: limits = {half_s = 1.0}
#: cause = "let the match wait for 1 s in all"

import threading

import arena

arena.drive(10)
lock = threading.Lock()
lock.acquire()
while arena.robot.step(32) != -1:
    lock.acquire(timeout=0.15)
