#: about = "time"
#: tries = "to wait in real time before its first step, in the middle of a class body"
#: holds = "the time limit for the start"
#: tick = 0
#: ends = "start_timeout at 0"
#: limits = {start_s = 3}
#: cause = "more than 3 s until its first step"
#: said = ["robot1.py|robot2.py|robot3.py"]

import _thread


class Slow:
    lock = _thread.allocate_lock()
    lock.acquire()
    lock.acquire()
