#: about = "processes and system"
#: tries = "to trace the match, to read and write its memory and to take its open files"
#: holds = "tracing is refused"
#: layers = ["system_calls"]
#: platforms = ["linux"]
#: tick = 10
#: ends = "plays on"
#: said = ["refused: ptrace", "refused: process_vm_readv", "refused: pidfd_open"]

import ctypes
import os

import arena

PTRACE_SEIZE = 0x4206


class Range(ctypes.Structure):
    _fields_ = [("base", ctypes.c_void_p), ("size", ctypes.c_size_t)]


arena.drive(10)
match = os.getppid()
own = ctypes.create_string_buffer(8)
mine, theirs = Range(ctypes.addressof(own), 8), Range(id(None), 8)
arena.syscall("ptrace", arena.number_of("ptrace"), PTRACE_SEIZE, match, 0, 0)
for name in ("process_vm_readv", "process_vm_writev"):
    arena.syscall(name, arena.number_of(name), match, ctypes.byref(mine), 0, ctypes.byref(theirs), 0, 0)
arena.syscall("pidfd_open", arena.number_of("pidfd_open"), match, 0)
arena.play_on()
