#: about = "processes and system"
#: tries = "to call step from many threads at once"
#: holds = "threads that call step take turns, and each step is complete"
#: tick = 10
#: ends = "plays on"
#: said = ["plays on"]

import threading

import arena

THREADS = 8

# All begin together, again and again.
together = threading.Barrier(THREADS + 1)


def step():
    for _ in range(5):
        together.wait()
        arena.robot.step(32)


arena.drive(10)
others = [threading.Thread(target=step, daemon=True) for _ in range(THREADS)]
for other in others:
    other.start()
step()
arena.play_on()
