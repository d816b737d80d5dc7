#: about = "output"
#: tries = "to replace sys.stdout and sys.stderr, and to close the real ones"
#: holds = "the match does not need them"
#: tick = 10
#: ends = "exit at 20"
#: cause = "came to its end"

import os
import sys

import arena


class Evil:
    def __getattr__(self, name):
        raise SystemExit(name)


arena.drive(10)
sys.stdout.close()
sys.stderr.close()
os.closerange(0, 3)
sys.stdout = sys.__stdout__ = None
sys.stderr = sys.__stderr__ = sys.stdin = Evil()
for _ in range(10):
    arena.robot.step(32)
