import time

from controller import Robot

robot = Robot()
motor = robot.getDevice("left wheel motor")
motor.setPosition(float("inf"))
while robot.step(32) != -1:
    began = time.time()
    motor.setVelocity(3)
    time.sleep(0.2)
    print(round(robot.getTime() / 0.032), f"{time.time() - began:.2f}")
