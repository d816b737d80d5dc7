#: about = "module"
#: tries = "to slow the match down with tens of thousands of device settings in every step"
#: holds = "only the last setting of each device in a step is sent"
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
