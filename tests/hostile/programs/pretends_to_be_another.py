#: about = "module"
#: tries = "to pretend to be another robot by changing its name, number and tick in the module"
#: holds = "its identity depends on its pipe, and every answer has to name the tick that it answers"
#: tick = 10
#: ends = "protocol at 12"
#: cause = "answers tick 9999 at tick 12"

import arena
from controller import _connection

arena.drive(10)
connection = _connection.connected()
connection.spec["name"] = "B1"
assert arena.robot.getName() == "B1"
for motor in arena.motors:
    motor.setVelocity(0)
arena.robot.step(32)
arena.robot.step(32)
connection.tick = 9999
arena.robot.step(32)
arena.play_on()
