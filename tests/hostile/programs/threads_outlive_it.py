#: about = "processes and system"
#: tries = "to live on in threads after its main program is over"
#: holds = "the end of the program is the end of its process"
#: tick = 10
#: ends = "exit at 10"
#: cause = "came to its end"

import threading

import arena

arena.drive(10)


def spin():
    while True:
        pass


for _ in range(3):
    threading.Thread(target=spin).start()
