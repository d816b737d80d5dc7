#: about = "processes and system"
#: tries = "to send bits to another program through locks on a file that both can read"
#: holds = "locks have no effect, and querying them is refused"
#: platforms = ["linux"]
#: layers = ["system_calls"]
#: tick = 10
#: ends = "plays on"
#: succeeds_without = true
#: said = ["refused: querying a lock", "refused: querying a lock of an open file", "flock: no bit", "fcntl: no bit"]

import fcntl
import os
import struct

import arena

F_OFD_GETLK, F_OFD_SETLK = 36, 37
LOCK = struct.Struct("hhqqi4x")
SHARED = os.__file__


def query(command):
    """Return which lock prevents one on the first byte."""
    return LOCK.unpack(fcntl.fcntl(receiver, command, LOCK.pack(fcntl.F_WRLCK, 0, 0, 1, 0)))


arena.drive(10)
sender = os.open(SHARED, os.O_RDONLY)
receiver = os.open(SHARED, os.O_RDONLY)  # its locks conflict with the sender's, as those of another process would

fcntl.flock(sender, fcntl.LOCK_EX | fcntl.LOCK_NB)
try:
    fcntl.flock(receiver, fcntl.LOCK_EX | fcntl.LOCK_NB)
    print("flock: no bit")
except BlockingIOError:
    print("BROKEN: flock carries a bit")

one_byte = LOCK.pack(fcntl.F_RDLCK, 0, 0, 1, 0)
fcntl.fcntl(sender, F_OFD_SETLK, one_byte)
fcntl.lockf(sender, fcntl.LOCK_SH | fcntl.LOCK_NB, 1)
print("fcntl: no bit")
arena.refused("querying a lock", query, fcntl.F_GETLK)
arena.refused("querying a lock of an open file", query, F_OFD_GETLK)
arena.play_on()
