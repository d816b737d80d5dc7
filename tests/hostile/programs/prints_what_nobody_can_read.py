#: about = "output"
#: tries = "to corrupt the log and the terminal: escapes, binary data, lone surrogates, right-to-left marks, a line of 4 MB, no line end"
#: holds = "a log is a separate file of bytes; readers decode it as UTF-8 with replacements"
#: tick = 10
#: ends = "plays on"
#: said = ["the very end"]

import os
import sys

import arena

arena.drive(10)
print("\x1b]0;owned\x07\x1b[2J\x1b[31m\x1b]52;c;b3duZWQ=\x07\udcff\ud800\u202e\x00\r")
sys.stdout.write("x" * 4_000_000)
sys.stdout.buffer.write(bytes(range(256)) * 10)
os.write(1, b"\xff\xfe\x00" * 1000)
sys.stderr.write("\ud800 and no line end")
print("\nthe very end")
arena.play_on()
