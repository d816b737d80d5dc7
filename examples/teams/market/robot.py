"""Sell what is wanted: push the ordered ball into the blue goal.

The idea: the referee tells where every ball is and which one is wanted, so nothing has to be searched. The robot in
whose half the wanted ball lies pushes it; the other one waits at its side, out of the way.
"""

import json
import math

from controller import Robot

TIME_STEP = 32  # ms
MAX_SPEED = 10  # rad/s
SHOP = (0.0, 0.8)  # m


def wrap(angle):
    return math.atan2(math.sin(angle), math.cos(angle))


robot = Robot()
side = -1 if robot.getName() == "Y1" else 1  # Y1 works in the west, Y2 in the east
left = robot.getDevice("left wheel motor")  # in this kit it sits on the right: left > right turns to the left
right = robot.getDevice("right wheel motor")
for motor in (left, right):
    motor.setPosition(float("inf"))
    motor.setVelocity(0)
gps = robot.getDevice("gps")
compass = robot.getDevice("compass")
referee = robot.getDevice("supervisor receiver")
for sensor in (gps, compass, referee):
    sensor.enable(TIME_STEP)

told = {}
while robot.step(TIME_STEP) != -1:
    # Two kinds of packets: the official one, a single byte, and what this challenge tells, as JSON.
    while referee.getQueueLength():
        packet = referee.getBytes()
        referee.nextPacket()
        if packet.endswith(b"}"):
            told = json.loads(packet)
    x, y, _ = gps.getValues()
    north = compass.getValues()
    heading = math.atan2(north[0], north[1])
    ball = told.get(told.get("wanted"))  # null while it is off the field
    if ball is not None and (ball[0] >= 0) == (side > 0):
        distance = math.hypot(ball[0] - x, ball[1] - y)
        to_ball = math.atan2(ball[1] - y, ball[0] - x)
        to_shop = math.atan2(SHOP[1] - ball[1], SHOP[0] - ball[0])
        error = wrap(to_ball - to_shop)
        # Behind the ball: push, a little past its far side. Else: drive around it, on the shorter way.
        direction = to_ball + error if abs(error) < 1.0 else to_ball + math.copysign(min(1.3, 0.16 / distance), error)
    else:
        home = (0.4 * side, -0.5)
        direction = math.atan2(home[1] - y, home[0] - x)
        if math.hypot(home[0] - x, home[1] - y) < 0.08:
            direction = heading  # there already
            left.setVelocity(0)
            right.setVelocity(0)
            continue
    turn = max(-MAX_SPEED, min(MAX_SPEED, 6 * wrap(direction - heading)))
    forward = MAX_SPEED - abs(turn)
    left.setVelocity(forward + turn)
    right.setVelocity(forward - turn)
