"""Find the ball of the called colour with the camera, and touch it.

The idea: turn until some pixels have the called colour, steer to their middle, and go on until another one is called.
How bright a picture is differs from match to match, so colours are compared by their shares of red, green and blue,
which stay the same.
"""

import json
import math

from controller import Robot

TIME_STEP = 32  # ms
MAX_SPEED = 10  # rad/s
ONE_TURN = 4.0  # s: looking around for longer is of no use
COLOURS = {"red": (224, 49, 49), "gold": (255, 212, 59), "cyan": (34, 184, 207), "violet": (112, 72, 232)}

robot = Robot()
left = robot.getDevice("left wheel motor")  # in this kit it sits on the right: left > right turns to the left
right = robot.getDevice("right wheel motor")
for motor in (left, right):
    motor.setPosition(float("inf"))
    motor.setVelocity(0)
camera = robot.getDevice("front camera")
sonar = robot.getDevice("distancesensor front")
referee = robot.getDevice("supervisor receiver")
for sensor in (camera, sonar, referee):
    sensor.enable(TIME_STEP)


def shares(red, green, blue):
    """How much of a colour is red and how much is green: the same in bright and in dim light."""
    total = red + green + blue or 1
    return red / total, green / total


def columns_with(colour):
    """The columns of all pixels that have a colour, one for each pixel."""
    image, width = camera.getImage() or b"", camera.getWidth()
    wanted_red, wanted_green = shares(*COLOURS[colour])
    columns = []
    for number, (blue, green, red) in enumerate(zip(image[0::4], image[1::4], image[2::4])):
        share_red, share_green = shares(red, green, blue)
        if abs(share_red - wanted_red) < 0.04 and abs(share_green - wanted_green) < 0.04:
            columns.append(number % width)
    return columns


def drive(forward, turn):
    """Drive; a positive turn is one to the left."""
    left.setVelocity(max(-MAX_SPEED, min(MAX_SPEED, forward + turn)))
    right.setVelocity(max(-MAX_SPEED, min(MAX_SPEED, forward - turn)))


called, side, seen_at = None, 1, 0.0
while robot.step(TIME_STEP) != -1:
    while referee.getQueueLength() > 0:
        packet = referee.getBytes()
        referee.nextPacket()
        if packet.endswith(b"}"):  # what this challenge broadcasts; the usual packet is a single byte
            called = json.loads(packet)["find"]
    columns = columns_with(called) if called else []
    now = robot.getTime()
    if columns:
        middle = (sum(columns) / len(columns) + 0.5) / camera.getWidth()  # 0 left, 1 right
        angle = math.atan((1 - 2 * middle) * math.tan(camera.getFov() / 2))  # positive to the left
        drive(MAX_SPEED * (1 - abs(angle)), 6 * angle)
        side, seen_at = (1 if angle > 0 else -1), now
    elif now - seen_at < ONE_TURN or sonar.getValue() < 250:  # mm
        drive(0, 4 * side)
    else:  # not to be seen from here: go somewhere else
        drive(MAX_SPEED, 0)
        if now - seen_at > ONE_TURN + 1.5:
            seen_at = now
