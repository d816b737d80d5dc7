#: about = "processes and system"
#: tries = "to send bits to another program by changing the free memory and disk space of the computer"
#: holds = "calls and files that show free memory and disk space are refused"
#: platforms = ["linux"]
#: layers = ["system_calls", "filesystem"]
#: tick = 10
#: ends = "plays on"
#: succeeds_without = true
#: said = ["refused: sysinfo", "refused: meminfo", "refused: free space"]

import ctypes
import os
from pathlib import Path

import arena

arena.drive(10)
arena.syscall("sysinfo", arena.number_of("sysinfo"), ctypes.byref(ctypes.create_string_buffer(256)))
arena.refused("meminfo", Path("/proc/meminfo").read_text, encoding="ascii")
arena.refused("free space", os.statvfs, ".")
arena.play_on()
