#: about = "time"
#: tries = "to wait in real time before its first step, in the middle of a class body"
#: holds = "the wall limit of the start"
#: tick = 0
#: ends = "start_timeout at 0"
#: limits = {start_s = 3}

import _thread


class Slow:
    lock = _thread.allocate_lock()
    lock.acquire()
    lock.acquire()
