import queue
import threading

from controller import Robot

lock = threading.Lock()
box = queue.Queue()
robot = Robot()
while robot.step(32) != -1:
    with lock:
        try:
            box.get(timeout=0.001)
        except queue.Empty:
            print("empty")
