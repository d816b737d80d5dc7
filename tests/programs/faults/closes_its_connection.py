import os
import time

from controller import Robot

robot = Robot()
robot.step(32)
os.closerange(3, 64)
while True:
    pass
