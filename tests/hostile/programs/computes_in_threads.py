#: about = "time"
#: tries = "to slow others down with two more threads that compute for ever"
#: holds = "no result depends on how long a program computes"
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
