import os

from controller import Robot

robot = Robot()
robot.step(32)
os._exit(3)
