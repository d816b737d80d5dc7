#: about = "endings"
#: tries = "to fill the report of its end with megabytes of control characters"
#: holds = "a program's report of its end is one line of at most 1000 characters"
#: tick = 10
#: ends = "exit at 10"
#: cause = "^the program called sys.exit: [^\\x00-\\x1f]{0,1000}$"

import sys

import arena

arena.drive(10)
sys.exit("\x1b[2J\x07\r\n\u202e\ud800" * 200_000)
