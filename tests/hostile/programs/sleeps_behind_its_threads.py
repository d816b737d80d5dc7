#: about = "time"
#: tries = "to sleep in every step, hidden behind thirty threads that wake together and wait for a processor"
#: holds = "all of a wait is charged, except the time for which the busiest thread was running or ready"
#: tick = 10
#: ends = "half_timeout"
#: limits = {half_s = 1.0}
#: cause = "more than 1 s for all its steps"
#: platforms = ["linux"]

import ctypes
import threading

import arena

EVERY_NS = 10_000_000
CLOCK, TIMER_ABSTIME = 1, 1


class Moment(ctypes.Structure):
    _fields_ = [("s", ctypes.c_long), ("ns", ctypes.c_long)]


def wake_together():
    libc, moment = arena.libc(), Moment()
    here = ctypes.byref(moment)
    while True:
        libc.clock_gettime(CLOCK, here)
        now_ns = moment.s * 10**9 + moment.ns
        moment.s, moment.ns = divmod((now_ns // EVERY_NS + 1) * EVERY_NS, 10**9)
        libc.clock_nanosleep(CLOCK, TIMER_ABSTIME, here, None)


arena.drive(10)
for _ in range(31):
    threading.Thread(target=wake_together, daemon=True).start()
while arena.robot.step(32) != -1:
    arena.libc().usleep(100_000)
