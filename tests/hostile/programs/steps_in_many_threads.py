#: about = "processes and system"
#: tries = "to call step from many threads at once"
#: holds = "the protocol: answers that come in no order end it"
#: tick = 10
#: ends = "protocol"

import threading

import arena


def step():
    while arena.robot.step(32) != -1:
        pass


arena.drive(10)
others = [threading.Thread(target=step) for _ in range(8)]
for other in others:
    other.start()
step()
