#: about = "processes and system"
#: tries = "to change everything that a process can change about itself: name, folder, umask, locale, environment, timers, parent-death signal"
#: holds = "it has its own process, and no other process is affected"
#: platforms = ["linux", "darwin"]
#: tick = 10
#: ends = "plays on"
#: said = ["plays on"]
#: variant = true

import contextlib
import locale
import os
import signal
import sys
import time

import arena

arena.drive(10)
os.chdir("/")
os.umask(0)
os.environ.clear()
os.environ["TZ"] = "Asia/Kathmandu"
time.tzset()
for deed in (
    lambda: locale.setlocale(locale.LC_ALL, "tr_TR.UTF-8"),
    lambda: os.nice(5),
    lambda: os.sched_setaffinity(0, {0}),
    lambda: arena.libc().prctl(1, 0, 0, 0, 0),
    lambda: arena.libc().prctl(15, b"systemd", 0, 0, 0),
    lambda: arena.libc().prctl(4, 0, 0, 0, 0),
    lambda: os.setsid(),
):
    with contextlib.suppress(Exception):
        deed()
signal.signal(signal.SIGALRM, lambda *_: None)
signal.setitimer(signal.ITIMER_REAL, 0.001, 0.001)
sys.setswitchinterval(1e-6)
sys.path[:0] = [f"/nowhere/{number}" for number in range(100_000)]
arena.play_on()
