#: about = "module"
#: tries = "to replace functions and classes of the controller module"
#: holds = "the module is on the program's side of the pipe, where nothing is decided"
#: tick = 10
#: ends = "plays on"
#: said = ["over at last"]
#: variant = true

import sys

import arena
import controller
from controller import _clock, _connection, _wire

arena.drive(10)
connection = _connection.connected()
real = connection.exchange
connection.time_s = lambda: 1e9
connection.exchange = lambda duration_ms: real(32)
_wire.leave = lambda status: None
_clock.Clock.missed_ticks = lambda self: 0
controller.Robot.getTime = lambda self: -1
controller.Motor = controller.Receiver = None
for name in [name for name in sys.modules if name.startswith("controller")]:
    del sys.modules[name]
arena.play_on()
print("over at last")
