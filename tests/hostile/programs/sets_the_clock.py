#: about = "processes and system"
#: tries = "to set the computer's clock (to the current time), and to read it instead of the simulated one"
#: holds = "setting it is refused; reading it is useless, because nothing in a match depends on it"
#: layers = ["system_calls"]
#: platforms = ["linux"]
#: tick = 10
#: ends = "plays on"
#: said = ["refused: clock_settime", "refused: settimeofday", "the real year is 20"]
#: variant = true

import ctypes

import arena


class Moment(ctypes.Structure):
    _fields_ = [("seconds", ctypes.c_long), ("rest", ctypes.c_long)]


arena.drive(10)
libc = arena.libc()
now = Moment()
libc.clock_gettime(0, ctypes.byref(now))
print("the real year is", 1970 + now.seconds // 31_556_952)
arena.syscall("clock_settime", arena.number_of("clock_settime"), 0, ctypes.byref(now))
libc.clock_gettime(0, ctypes.byref(now))
now.rest //= 1000
arena.syscall("settimeofday", arena.number_of("settimeofday"), ctypes.byref(now), None)
arena.play_on()
