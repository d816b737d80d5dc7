#: about = "time"
#: tries = "to ignore every signal and never start"
#: holds = "the time limit for the start, then SIGKILL, which cannot be ignored"
#: tick = 0
#: ends = "start_timeout at 0"
#: limits = {start_s = 3}
#: variant = true

import signal

for number in signal.valid_signals():
    try:
        signal.signal(number, signal.SIG_IGN)
    except (OSError, ValueError):
        pass
while True:
    pass
