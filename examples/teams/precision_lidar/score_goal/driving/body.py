"""The robot's body: where it is now, how fast its sides move, and where it will be after the next steps.

A robot at full speed cannot stop at once: its wheels slip. With a small model of the slipping wheels we look ahead, know
where we will end up, and brake at the right moment. The referee's packets are old: since they were sent we have driven
on, so we add what our own commands have done since then.
"""

import math

from driving.field import WHEEL_ARM, WHEEL_RADIUS, wrap

STEP_MS = 32
STEP = STEP_MS / 1000

# How fast a wheel can change the speed of its side of the robot, in m/s^2 (measured). If we ask for more, it slips.
PUSHES, REVERSES, BRAKES = 4.4, 6.5, 10.0


def slip(before, wanted):
    """One side of the robot in one step: its speed afterwards, and its mean speed."""
    backwards = before * wanted < 0
    if 0 <= before * wanted < before * before or (backwards and abs(before) > 0.15):
        rate = BRAKES
    else:
        rate = REVERSES if backwards and abs(before) > 0.06 else PUSHES
    speed, total = before, 0.0
    for _ in range(4):  # the world is computed in steps of 8 ms
        speed += max(-rate * STEP / 4, min(rate * STEP / 4, wanted - speed))
        total += speed
    return speed, total / 4


def look_ahead(sides, commands):
    """How far we drive and how far we turn, given these (left, right) speeds, one pair a step."""
    way = turn = 0.0
    left, right = sides
    for wanted_left, wanted_right in commands:
        left, mean_left = slip(left, wanted_left)
        right, mean_right = slip(right, wanted_right)
        way += (mean_left + mean_right) / 2 * STEP
        turn += (mean_right - mean_left) / (2 * WHEEL_ARM) * STEP
    return way, turn


class Body:
    """Pose of the robot, and its motors. The more it steers, the sooner it is back on a straight way."""

    def __init__(self, robot, steers=15):
        self.steers = steers
        self.motors = robot.getDevice("left wheel motor"), robot.getDevice("right wheel motor")
        for motor in self.motors:
            motor.setPosition(float("inf"))
            motor.setVelocity(0.0)
        self.position = (0.0, 0.0)
        self.heading = 0.0
        self.sides = (0.0, 0.0)  # how fast our left and our right side move forwards, in m/s
        self.moved = (0.0, 0.0)  # way and turn of the last step

    def is_at(self, position, heading):
        """What the sensors say."""
        self.position, self.heading = position, heading

    def seen_at(self, position, heading):
        """The referee saw us there one step ago."""
        self.is_at(position, heading)
        self.go_on()

    def go_on(self):
        """Add the last step to where we were."""
        way, turn = self.moved
        middle = self.heading + turn / 2
        self.position = (self.position[0] + way * math.cos(middle), self.position[1] + way * math.sin(middle))
        self.heading = wrap(self.heading + turn)

    def command(self, left, right):
        """Set the motors: speeds of our left and our right side in m/s."""
        for motor, speed in zip(self.motors, (left, right)):
            # In 2021 negative velocities drive forwards. Rounded, because 10.000000000000002 would be too fast.
            motor.setVelocity(-round(speed / WHEEL_RADIUS, 6))
        self.moved = look_ahead(self.sides, [(left, right)])
        self.sides = slip(self.sides[0], left)[0], slip(self.sides[1], right)[0]
