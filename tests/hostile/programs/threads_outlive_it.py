#: about = "processes and system"
#: tries = "to survive in threads after its main thread has ended"
#: holds = "the match waits for threads as the interpreter does at exit, but no longer than the time limit for a step"
#: tick = 10
#: ends = "step_timeout at 10"
#: limits = {step_s = 1.0}

import threading

import arena

arena.drive(10)


def spin():
    while True:
        pass


for _ in range(3):
    threading.Thread(target=spin).start()
