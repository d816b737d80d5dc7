"""Drive a slalom: one point after the other, as fast as the wheels turn.

The idea: a list of points that lead through the gates without touching a post. Turn to the next point, drive, and take
the one after it as soon as this one is near. How near is the secret of speed: cut the corners, but spare the posts.
"""

import json
import math

from controller import Robot

TIME_STEP = 32  # ms
MAX_SPEED = 10  # rad/s
NEAR = 0.07  # m: from here on the next point counts

# Before and behind each gate, in metres.
POINTS = [(0.18, -0.42), (0.18, -0.28), (-0.18, -0.12), (-0.18, 0.02), (0.18, 0.18), (0.18, 0.32), (0.1, 0.6)]

robot = Robot()
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

next_point = 0
while robot.step(TIME_STEP) != -1:
    # The referee sends its official packet, and every fifth tick what this challenge tells: gates passed so far.
    while referee.getQueueLength():
        packet = referee.getBytes()
        referee.nextPacket()
        if packet.endswith(b"}") and json.loads(packet)["touched_posts"]:
            NEAR = 0.05  # be more careful
    x, y, _ = gps.getValues()
    north = compass.getValues()
    heading = math.atan2(north[0], north[1])
    target = POINTS[next_point]
    if math.hypot(target[0] - x, target[1] - y) < NEAR and next_point < len(POINTS) - 1:
        next_point += 1
        target = POINTS[next_point]
    angle = math.atan2(target[1] - y, target[0] - x) - heading
    angle = math.atan2(math.sin(angle), math.cos(angle))
    turn = max(-MAX_SPEED, min(MAX_SPEED, 8 * angle))
    forward = MAX_SPEED - abs(turn)
    left.setVelocity(forward + turn)
    right.setVelocity(forward - turn)
