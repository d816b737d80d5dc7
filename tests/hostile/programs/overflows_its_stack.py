#: about = "endings"
#: tries = "to overflow the stack of its process after raising the interpreter's recursion limit"
#: holds = "each program has its own process"
#: platforms = ["linux", "darwin"]
#: tick = 10
#: ends = "crash at 10"
#: variant = true

import sys

import arena

arena.drive(10)
sys.setrecursionlimit(10**9)
first, second = [], []
for _ in range(1_000_000):
    first, second = [first], [second]
print(first == second)
