import threading

from controller import Robot

robot = Robot()
wait = threading.Lock()
wait.acquire()
while robot.step(32) != -1:
    wait.acquire(timeout=0.05)
