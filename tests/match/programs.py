"""Small programs for matches in tests."""

DRIVE = """
from controller import Robot
robot = Robot()
motors = [robot.getDevice(side + " wheel motor") for side in ("left", "right")]
for motor in motors:
    motor.setPosition(float("inf"))
    motor.setVelocity({speed})
while robot.step(32) != -1:
    pass
"""
STAND = DRIVE.format(speed=0)
AHEAD = DRIVE.format(speed=10)
