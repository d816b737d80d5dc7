"""Classic Plus: two wheels, GPS and ball receiver as usual, and a kicker for shots at the goal."""

import math

from controller import Robot

robot = Robot()
blue, number = robot.getName()[0] == "B", int(robot.getName()[1])
left_motor, right_motor = robot.getDevice("left wheel motor"), robot.getDevice("right wheel motor")
kicker, dribbler = robot.getDevice("kicker"), robot.getDevice("dribbler")
for motor in (left_motor, right_motor, dribbler):
    motor.setPosition(float("inf"))
gps, compass, ball_receiver = robot.getDevice("gps"), robot.getDevice("compass"), robot.getDevice("ball receiver")
ball_sensor, referee = robot.getDevice("ball sensor"), robot.getDevice("supervisor receiver")
for sensor in (gps, compass, ball_receiver, ball_sensor, referee):
    sensor.enable(32)
GOAL_Y = -0.75 if blue else 0.75  # m: where we score
HOMES = {1: (0.0, -0.5), 2: (0.25, -0.1), 3: (-0.25, -0.1)}  # m, as yellow sees them


def wrap(angle):
    """Bring an angle into the range from -pi to pi."""
    return math.atan2(math.sin(angle), math.cos(angle))


def drive_to(angle):
    """Drive to something at this angle (rad, positive to the left), turning while driving."""
    turn = max(-10, min(10, 8 * angle))
    left_motor.setVelocity(10 - abs(turn) - turn)
    right_motor.setVelocity(10 - abs(turn) + turn)


waiting = False
while robot.step(32) != -1:
    while referee.getQueueLength() > 0:
        waiting = referee.getBytes() == b"\x01"
        referee.nextPacket()
    sine, cosine, _ = compass.getValues()
    heading = math.atan2(sine, cosine)
    x, y, _ = gps.getValues()
    goal = wrap(math.atan2(GOAL_Y - y, -x) - heading)  # the angle of the goal from here
    ball = None
    while ball_receiver.getQueueLength() > 0:
        ahead, left, _ = ball_receiver.getEmitterDirection()
        ball = math.atan2(left, ahead), 1 / math.sqrt(ball_receiver.getSignalStrength())
        ball_receiver.nextPacket()
    has_ball = ball_sensor.getValue() < 8  # mm
    dribbler.setVelocity(50 if ball is not None and ball[1] < 0.12 else 0)
    kicker.setPosition(0.04 if has_ball and abs(goal) < 0.25 else 0)
    if waiting:
        left_motor.setVelocity(0)
        right_motor.setVelocity(0)
    elif ball is not None:
        angle, distance = ball
        error = wrap(angle - goal)  # 0: the ball is on the way to the goal
        if abs(error) > 0.8:  # past the ball first, near but without touching it
            angle += math.copysign(math.asin(min(1, 0.14 / distance)), error)
        drive_to(wrap(angle))
    else:
        home_x, home_y = (-a if blue else a for a in HOMES[number])
        if math.hypot(home_x - x, home_y - y) > 0.05:
            drive_to(wrap(math.atan2(home_y - y, home_x - x) - heading))
        else:
            left_motor.setVelocity(3)
            right_motor.setVelocity(-3)
