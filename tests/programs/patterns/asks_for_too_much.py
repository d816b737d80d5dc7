import math

from controller import Robot

robot = Robot()
motor = robot.getDevice("left wheel motor")
other = robot.getDevice("right wheel motor")
motor.setPosition(math.inf)
other.setPosition(math.inf)
other.setVelocity(1)
robot.step(32)
motor.setVelocity(15)
robot.step(32)
motor.setVelocity(-15)
robot.step(32)
motor.setVelocity(math.nan)
motor.setPosition(math.nan)
robot.step(32)
motor.setAcceleration(20)
motor.enableTorqueFeedback(32)
print(motor.getVelocity(), motor.getMaxVelocity(), motor.getTargetPosition())
while robot.step(32) != -1:
    pass
