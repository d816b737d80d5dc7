#: about = "endings"
#: tries = "to wait for keyboard input"
#: holds = "its input is empty"
#: tick = 10
#: ends = "crash at 10"
#: cause = "EOFError"

import sys

import arena

arena.drive(10)
print(sys.stdin.read())
input("your turn: ")
