#: about = "module"
#: tries = "to replace builtins, time, os, struct and the modules that the match's code uses"
#: holds = "it replaces them in its own process only"
#: tick = 10
#: ends = "exit at 10"

import builtins
import os
import struct
import time

import arena

arena.drive(10)


def wrong(*_, **__):
    raise SystemExit(0)


real = os.write
time.time = time.sleep = time.perf_counter = wrong
struct.pack = struct.unpack = struct.Struct = wrong
for name in ("print", "len", "open", "isinstance", "Exception", "OSError", "__import__", "type"):
    setattr(builtins, name, wrong)
os.read = os.write = wrong
