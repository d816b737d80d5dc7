"""Find the ball of the called colour: the camera recognizes balls by itself, and says where they are.

The idea: turn until the called ball is in the list of what the camera recognizes, and drive to it, around other balls.
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
camera.recognitionEnable(TIME_STEP)
sonar.enable(TIME_STEP)
referee.enable(TIME_STEP)


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
    now, found, in_the_way = robot.getTime(), None, None
    for ball in camera.getRecognitionObjects():
        ahead, to_the_left, _ = ball.position
        angle, distance = math.atan2(to_the_left, ahead), math.hypot(ahead, to_the_left)
        colour = tuple(round(255 * part) for part in ball.colors)
        if called and colour == COLOURS[called]:
            found = (angle, distance)
        elif in_the_way is None and distance < 0.25:  # they are listed by distance: the first is the nearest
            in_the_way = (angle, distance)
    if found:
        angle, distance = found
        side, seen_at = (1 if angle > 0 else -1), now
        if in_the_way and in_the_way[1] < distance and abs(in_the_way[0] - angle) < 0.4:
            angle = in_the_way[0] + (0.5 if angle > in_the_way[0] else -0.5)  # pass beside it
        drive(MAX_SPEED * (1 - abs(angle)), 6 * angle)
    elif now - seen_at < ONE_TURN or sonar.getValue() < 250:  # mm
        drive(0, 4 * side)
    else:  # not to be seen from here: go somewhere else
        drive(MAX_SPEED, 0)
        if now - seen_at > ONE_TURN + 1.5:
            seen_at = now
