"""The trivial program of the benchmark: reads what a simple team reads, and runs after the ball."""

from controller import Robot

robot = Robot()
left, right = robot.getDevice("left wheel motor"), robot.getDevice("right wheel motor")
for motor in (left, right):
    motor.setPosition(float("inf"))
    motor.setVelocity(0.0)
gps, compass = robot.getDevice("gps"), robot.getDevice("compass")
sonars = [robot.getDevice(f"distancesensor {side}") for side in ("left", "right", "front", "back")]
ball, referee = robot.getDevice("ball receiver"), robot.getDevice("supervisor receiver")
for device in (gps, compass, *sonars, ball, referee):
    device.enable(32)

while robot.step(32) != -1:
    gps.getValues()
    compass.getValues()
    for sonar in sonars:
        sonar.getValue()
    while referee.getQueueLength() > 0:
        referee.nextPacket()
    turn, ahead = 5.0, 0.0
    while ball.getQueueLength() > 0:
        x, y, _ = ball.getEmitterDirection()
        turn, ahead = 6.0 * y, 8.0 * x
        ball.nextPacket()
    left.setVelocity(max(-10.0, min(10.0, ahead + turn)))
    right.setVelocity(max(-10.0, min(10.0, ahead - turn)))
