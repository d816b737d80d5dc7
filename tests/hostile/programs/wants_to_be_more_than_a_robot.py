#: about = "module"
#: tries = "to be the referee or a second robot, and to use other channels"
#: holds = "a program has one robot, and its radio has only its team's channels"
#: tick = 10
#: ends = "plays on"
#: said = ["this second Supervisor is the same robot", "the same: True True", "is not for this team"]

import arena
import controller

arena.drive(10)
robot = arena.robot
coach, second = controller.Supervisor(), controller.Robot()
print("the same:", coach.getName() == robot.getName(), second.getDevice("gps") is robot.getDevice("gps"))
arena.refused("supervisor", lambda: robot.getFromDef("BALL"))
for name in ("team receiver", "team emitter", "supervisor receiver"):
    device = robot.getDevice(name)
    if device is not None:
        for channel in (*range(8), -1, 2**40, -(2**40)):
            device.setChannel(channel)
            robot.getDevice("team emitter").send(b"go home")
arena.robot.step(32)
arena.play_on()
