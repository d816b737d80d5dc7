"""Stand where the ball will cross, and meet it with the front.

The idea: two looks at the ball tell where it rolls. The robot waits on its line with its side to the shot, so that it
can drive along the line at once; it stops where the ball will cross.
"""

import math

from controller import Robot

TIME_STEP = 32  # ms
MAX_SPEED = 10  # rad/s
LINE_Y = -0.66  # m
WIDEST_X = 0.16  # m; further out the goal ends
LOOKS = 6  # how many looks back the ball's way is measured over


def clipped(value, limit):
    return max(-limit, min(limit, value))


robot = Robot()
left = robot.getDevice("left wheel motor")  # in this kit it sits on the right: left > right turns to the left
right = robot.getDevice("right wheel motor")
for motor in (left, right):
    motor.setPosition(float("inf"))
    motor.setVelocity(0)
gps = robot.getDevice("gps")
compass = robot.getDevice("compass")
ears = robot.getDevice("ball receiver")
for sensor in (gps, compass, ears):
    sensor.enable(TIME_STEP)

seen = []  # where the ball was in the last looks, the newest last
while robot.step(TIME_STEP) != -1:
    x, y, _ = gps.getValues()
    north = compass.getValues()
    heading = math.atan2(north[0], north[1])
    while ears.getQueueLength():
        ahead, to_left, _ = ears.getEmitterDirection()
        distance = 1 / math.sqrt(ears.getSignalStrength())
        ears.nextPacket()
        angle = heading + math.atan2(to_left, ahead)
        seen.append((x + distance * math.cos(angle), y + distance * math.sin(angle)))
    seen = seen[-LOOKS:]
    goal_x = 0.0
    if len(seen) == LOOKS:
        (old_x, old_y), (ball_x, ball_y) = seen[0], seen[-1]
        if old_y - ball_y > 0.01:  # it comes nearer
            goal_x = clipped(ball_x + (ball_x - old_x) / (old_y - ball_y) * (ball_y - LINE_Y), WIDEST_X)
        if math.dist(seen[0], seen[-1]) > 0.5:
            seen = []  # it was put elsewhere
    # Along the line: forwards to the right, backwards to the left; a little turn brings it back onto the line.
    forward = clipped(80 * (goal_x - x), MAX_SPEED)
    wanted = clipped(4 * (LINE_Y - y), 0.4) * (1 if forward > 0 else -1)
    turn = clipped(6 * math.atan2(math.sin(wanted - heading), math.cos(wanted - heading)), 4)
    left.setVelocity(clipped(forward + turn, MAX_SPEED))
    right.setVelocity(clipped(forward - turn, MAX_SPEED))
