import threading

from controller import Robot

robot = Robot()
wait = threading.Event()
while robot.step(32) != -1:
    wait.wait(0.05)
