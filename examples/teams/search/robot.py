"""Find a crate with one sonar, and tell the referee by radio where it is.

The idea: drive up and down along the left wall, and look across the field with the sonar on that side. While the crate is
beside the robot, the sonar shows less than without it. Where that begins and where it ends are the two edges of the
crate: its middle lies between them. How far it is away is the mean of all readings in between, since each has an error.
"""

import math

from controller import Robot

TIME_STEP = 32  # ms
MAX_SPEED = 10  # rad/s
LANE = -0.58  # m: where to drive up and down, beside everything that could stand in the way
END = 0.6  # m: turn round here
SONAR = 0.0375  # m: from the middle of the robot to its side, where the sonar sits
CRATE = 0.05  # m: from the side of the crate to its middle
SEEN = 1.0  # m: the wall on the other side is further away than this
REFEREE = 1  # the channel on which the referee listens

robot = Robot()
left = robot.getDevice("left wheel motor")  # in this kit it sits on the right: left > right turns to the left
right = robot.getDevice("right wheel motor")
for motor in (left, right):
    motor.setPosition(float("inf"))
    motor.setVelocity(0)
gps = robot.getDevice("gps")
compass = robot.getDevice("compass")
eyes = {1: robot.getDevice("distancesensor right"), -1: robot.getDevice("distancesensor left")}
for sensor in (gps, compass, *eyes.values()):
    sensor.enable(TIME_STEP)
emitter = robot.getDevice("team emitter")
emitter.setChannel(REFEREE)


def drive(x, heading, way):
    """Drive along the lane: up (way 1) or down (way -1)."""
    wanted = way * math.pi / 2 + 2 * way * (x - LANE)  # too far to the right: steer to the left
    angle = math.atan2(math.sin(wanted - heading), math.cos(wanted - heading))
    turn = max(-MAX_SPEED, min(MAX_SPEED, 8 * angle))
    forward = MAX_SPEED - abs(turn)
    left.setVelocity(forward + turn)
    right.setVelocity(forward - turn)
    return abs(angle) < 0.05


way = 1
found = []  # (x, y) of what the sonar sees, one for each step
while robot.step(TIME_STEP) != -1:
    x, y, _ = gps.getValues()
    north = compass.getValues()
    heading = math.atan2(north[0], north[1])
    if way * y > END:
        way = -way
        found = []
    straight = drive(x, heading, way)
    seen = eyes[way].getValue() / 1000  # mm
    if straight and seen < 0.95 * SEEN:
        found.append((x + SONAR + seen, y))
    elif found:
        # The edge has just gone by. A single echo may be anything.
        if len(found) > 5:
            middle_x = sum(point[0] for point in found) / len(found) + CRATE
            middle_y = (found[0][1] + found[-1][1]) / 2
            emitter.send([middle_x, middle_y])
            print(f"I see the crate at {middle_x:.2f}, {middle_y:.2f}")
        found = []
