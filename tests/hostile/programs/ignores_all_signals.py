#: about = "time"
#: tries = "to survive SIGTERM, SIGINT, SIGABRT and all others while it hangs"
#: holds = "SIGKILL, which cannot be ignored"
#: tick = 10
#: ends = "step_timeout at 10"

import faulthandler
import signal

import arena

arena.drive(10)
faulthandler.disable()
for number in signal.valid_signals():
    try:
        signal.signal(number, lambda *_: None)
    except (OSError, ValueError):
        pass
if hasattr(signal, "pthread_sigmask"):
    signal.pthread_sigmask(signal.SIG_BLOCK, signal.valid_signals())
while True:
    pass
