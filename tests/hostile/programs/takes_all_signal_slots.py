#: about = "processes and system"
#: tries = "to take all timers and queued signals that its user may have, so that no other process of this user gets one"
#: holds = "it gets only a few of them"
#: layers = ["resource_limits"]
#: platforms = ["linux"]
#: tick = 10
#: ends = "plays on"
#: succeeds_without = true
#: said = ["refused: raise the limit", "timers: few"]

import ctypes
import resource
import signal

import arena

arena.drive(10)
unlimited = (resource.RLIM_INFINITY, resource.RLIM_INFINITY)
try:
    resource.setrlimit(resource.RLIMIT_SIGPENDING, unlimited)
except (OSError, ValueError):
    print("refused: raise the limit")
timers = []
for _ in range(200):
    timer = ctypes.c_void_p()
    if arena.libc().timer_create(signal.ITIMER_PROF, None, ctypes.byref(timer)):
        break
    timers.append(timer)
print("timers: few" if len(timers) <= 64 else f"BROKEN: {len(timers)} timers")
for timer in timers:
    arena.libc().timer_delete(timer)
arena.play_on()
