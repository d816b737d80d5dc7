from controller import Robot

robot = Robot()
ball = robot.getDevice("ball receiver")
ball.enable(64)
while robot.step(64) != -1:
    if ball.getQueueLength() > 0:
        print(round(robot.getTime() / 0.032), ball.getData().decode(), ball.getQueueLength())
        ball.nextPacket()
