#: about = "endings"
#: tries = "to break the report of its end: the code of its SystemExit raises an error on every use"
#: holds = "errors from such a value are caught: it counts as an exit"
#: tick = 10
#: ends = "exit at 10"
#: cause = "the program called sys.exit"
#: variant = true

import sys

import arena


class Trap:
    def __getattribute__(self, name):
        raise KeyboardInterrupt

    __str__ = __repr__ = __format__ = __getattribute__


arena.drive(10)
sys.exit(Trap())
