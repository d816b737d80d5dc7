#: about = "module"
#: tries = "to delete all builtins and all modules"
#: holds = "it deletes them in its own process only, which then crashes or exits"
#: tick = 10
#: ends = "exit|crash|protocol"

import builtins
import sys

import arena

arena.drive(10)
step = arena.robot.step
sys.modules.clear()
builtins.__dict__.clear()
while step(32) != -1:
    nothing
