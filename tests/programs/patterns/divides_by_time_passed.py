import time

from controller import Robot

robot = Robot()
before = time.time()
fine = time.perf_counter_ns()
while robot.step(32) != -1:
    now = time.time()
    speed = 1 / (now - before)
    assert 1 / (time.perf_counter_ns() - fine)
    print(f"{now - before:.3f}", f"{speed:.0f}")
    before = now
    fine = time.perf_counter_ns()
