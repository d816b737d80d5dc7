#: about = "time"
#: tries = "to slow others down: two more threads that compute for ever"
#: holds = "nothing in a match depends on how long a program thinks"
#: tick = 10
#: ends = "plays on"
#: said = ["plays on"]
#: variant = true

import threading

import arena

arena.drive(10)


def spin():
    while True:
        pass


for _ in range(2):
    threading.Thread(target=spin, daemon=True).start()
arena.play_on()
