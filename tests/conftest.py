"""For all tests: processes that they start can be interrupted, also where the suite itself runs in the background."""

import signal

# A shell lets what it starts with `&` ignore Ctrl-C, and a process inherits what is ignored.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
