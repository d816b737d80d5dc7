#: about = "time"
#: tries = "to hang at its end, with exit handlers, threads and __del__ methods that never return"
#: holds = "no code of a program runs after it has reported its end"
#: tick = 10
#: ends = "exit at 10"
#: cause = "sys.exit.0."

import atexit
import sys
import threading

import arena


def forever(*_):
    while True:
        pass


class Immortal:
    __del__ = forever


arena.drive(10)
sys.immortal = Immortal()
atexit.register(forever)
threading._register_atexit(forever)
threading.Thread(target=threading.Event().wait).start()
sys.exit(0)
