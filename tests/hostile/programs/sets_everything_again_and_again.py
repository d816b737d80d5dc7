#: about = "module"
#: tries = "to slow down the match with tens of thousands of settings of its devices in every step"
#: holds = "only the last setting of a device in a step is sent"
#: tick = 10
#: ends = "plays on"
#: said = ["plays on"]
#: variant = true

import arena

arena.drive(10)
robot = arena.robot
receiver, emitter = robot.getDevice("team receiver"), robot.getDevice("team emitter")
for _ in range(3):
    for number in range(20_000):
        receiver.enable(32)
        receiver.setChannel(number)
    robot.step(32)
arena.play_on()
