#: about = "time"
#: tries = "to sleep for a billion years of simulated time"
#: holds = "the clock is simulated: the match does not wait, and the robot misses ticks"
#: tick = 10
#: ends = "plays on"
#: said = ["slept until 1e\\+|it is over"]

import time

import arena

arena.drive(10)
arena.robot.step(32)
for strange in (-1, float("nan"), float("inf"), "soon", None, 10**400):
    arena.refused(f"sleep {str(strange)[:5]}", time.sleep, strange)
time.sleep(1e15)
print("slept until 1e+", flush=True)
arena.play_on()
print("it is over")
