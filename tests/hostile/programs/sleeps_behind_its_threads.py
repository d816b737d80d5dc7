#: about = "time"
#: tries = "to sleep in every step, excused by thirty threads that wake together and wait for a processor"
#: holds = "only the longest running plus ready time of one thread excuses a wait"
#: tick = 10
#: ends = "half_timeout"
#: limits = {half_s = 1.0}
#: cause = "more than 1 s for all its steps"
#: platforms = ["linux"]

import ctypes
import os
import threading

import arena

EVERY_NS = 5_000_000


class Moment(ctypes.Structure):
    _fields_ = [("s", ctypes.c_long), ("ns", ctypes.c_long)]


def wake_together():
    moment = Moment()
    while True:
        arena.libc().clock_gettime(1, ctypes.byref(moment))
        now_ns = moment.s * 10**9 + moment.ns
        moment.s, moment.ns = divmod((now_ns // EVERY_NS + 1) * EVERY_NS, 10**9)
        arena.libc().clock_nanosleep(1, 1, ctypes.byref(moment), None)


arena.drive(10)
os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})
for _ in range(30):
    threading.Thread(target=wake_together, daemon=True).start()
while arena.robot.step(32) != -1:
    arena.libc().usleep(100_000)
