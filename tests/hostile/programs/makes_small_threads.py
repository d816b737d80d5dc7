#: about = "processes and system"
#: tries = "to start more threads than allowed, with small stacks"
#: holds = "its threads are counted while the match waits"
#: platforms = ["linux"]
#: tick = 10
#: ends = "memory at 10"
#: cause = "more than 32 threads"

import threading

import arena

arena.drive(10)
threading.stack_size(1 << 16)
for _ in range(80):
    threading.Thread(target=threading.Event().wait, daemon=True).start()
while True:
    pass
