import math

from controller import Robot

robot = Robot()
ball = robot.getDevice("ball receiver")
ball.enable(32)
while robot.step(32) != -1:
    while ball.getQueueLength() > 0:
        x, y, z = ball.getEmitterDirection()
        distance = math.sqrt(1 / ball.getSignalStrength())
        print(round(x / z, 3), round(y / z, 3), round(distance, 3))
        ball.nextPacket()
