#: about = "processes and system"
#: tries = "to live on in threads after its main program is over"
#: holds = "the match waits for threads as the interpreter does at its end, but not longer than for any step"
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
