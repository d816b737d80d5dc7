#: about = "processes and system"
#: tries = "to call step from many threads at once"
#: holds = "the protocol: answers that come in no order end it"
#: tick = 10
#: ends = "protocol"

import threading

import arena

THREADS = 8

# Steps that happen to come one after the other are no fault: all begin together, again and again.
together = threading.Barrier(THREADS + 1)


def step():
    while True:
        together.wait()
        arena.robot.step(32)


arena.drive(10)
others = [threading.Thread(target=step, daemon=True) for _ in range(THREADS)]
for other in others:
    other.start()
step()
