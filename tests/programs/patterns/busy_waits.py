import time

from controller import Robot

robot = Robot()
while robot.step(32) != -1:
    until = time.time() + 0.1
    while time.time() < until:
        pass
    print(round(robot.getTime() / 0.032))
