"""Good Old Days: a team for the robots of 2021.

Those robots see and hear nothing by themselves. The referee tells all of them where everybody is, every 64 ms, and the
idea of this team needs no more than that:

* the goalkeeper (robot 3) stays before its goal and keeps level with the ball,
* the one of the two others that is nearer to the ball goes behind it and pushes it towards the goal,
* the other one waits further back, and changes places as soon as it is nearer.

The packets call the direction to the blue goal `x` and the direction across the field `z`. We turn the field so that we
always attack towards positive x, whichever colour we have.
"""

import math
import struct

from controller import Robot

TIME_STEP = 64  # ms, from packet to packet
MAX_SPEED = 10  # rad/s: the motors do not turn faster
PACKET = struct.Struct("18d2d?")  # x, z and orientation of B1 B2 B3 Y1 Y2 Y3; x and z of the ball; waiting for kick-off
ROBOTS = ["B1", "B2", "B3", "Y1", "Y2", "Y3"]
GOAL = (0.75, 0.0)  # the one that we attack
BEHIND = 0.09  # metres: from there on we push
SWING = 0.07  # metres: who waits goes to and fro, for who stands still for 15 s is put somewhere else


def wrap(angle):
    """Bring an angle (rad) into the range from -pi to pi, so that we always turn the short way."""
    return math.atan2(math.sin(angle), math.cos(angle))


def place_behind(ball):
    """The point from which the ball lies before the goal."""
    to_goal = math.atan2(GOAL[1] - ball[1], GOAL[0] - ball[0])
    return ball[0] - BEHIND * math.cos(to_goal), ball[1] - BEHIND * math.sin(to_goal)


class Player:
    """One robot: listens to the referee, decides where to go, and drives there."""

    def __init__(self):
        self.robot = Robot()
        self.name = self.robot.getName()  # "B1" … "Y3"
        self.side = 1 if self.name[0] == "Y" else -1  # yellow attacks towards positive x, blue the other way
        self.motors = [self.robot.getDevice(f"{side} wheel motor") for side in ("left", "right")]
        for motor in self.motors:
            motor.setPosition(float("inf"))
            motor.setVelocity(0.0)
        self.receiver = self.robot.getDevice("receiver")
        self.receiver.enable(TIME_STEP)

    def run(self):
        while self.robot.step(TIME_STEP) != -1:
            numbers = self.listen()
            if numbers is None:
                continue  # the first packet comes after two steps
            robots = {name: numbers[3 * i : 3 * i + 2] for i, name in enumerate(ROBOTS)}
            robots = {name: (self.side * x, self.side * z) for name, (x, z) in robots.items()}
            ball = self.side * numbers[18], self.side * numbers[19]
            orientation = numbers[3 * ROBOTS.index(self.name) + 2]
            if self.side < 0:
                orientation += math.pi  # the field is turned by half a turn, and we with it
            self.drive(robots[self.name], orientation, self.target(robots, ball))

    def listen(self):
        """The newest packet, None if there is none."""
        packet = None
        while self.receiver.getQueueLength() > 0:
            packet = self.receiver.getData()
            self.receiver.nextPacket()
        return None if packet is None else PACKET.unpack(packet)

    def target(self, robots, ball):
        """Where we want to go: x and z."""
        swing = SWING * math.sin(2 * self.robot.getTime())
        number = self.name[1]
        if number == "3":
            return -0.56, max(-0.2, min(0.2, ball[1])) + swing
        mate = robots[self.name[0] + ("2" if number == "1" else "1")]
        me = robots[self.name]
        if math.dist(mate, ball) < math.dist(me, ball):
            return max(-0.5, ball[0] - 0.4), -0.5 * ball[1] + swing
        return self.attack(me, ball)

    def attack(self, me, ball):
        """Behind the ball first; from there through it."""
        start = place_behind(ball)
        if math.dist(me, start) < 0.04 or (me[0] < start[0] and abs(me[1] - ball[1]) < 0.03):
            return GOAL
        if me[0] > ball[0] - 0.03 and abs(me[1] - ball[1]) < 0.11:
            # We stand before the ball: drive around it, on the side on which we are.
            aside = 0.14 if me[1] > ball[1] else -0.14
            return ball[0] - BEHIND, max(-0.56, min(0.56, ball[1] + aside))
        return start

    def drive(self, me, orientation, target):
        """Turn to the target and drive, forwards or backwards, whatever is less to turn."""
        # The robot looks along (sin orientation, cos orientation) in x and z.
        course = math.atan2(target[0] - me[0], target[1] - me[1])
        off = wrap(course - orientation)
        gear = 1
        if abs(off) > math.pi / 2:
            gear, off = -1, wrap(off + math.pi)
        speed = MAX_SPEED * gear * max(0.0, 1 - abs(off)) * min(1.0, math.dist(me, target) / 0.05)
        turn = max(-MAX_SPEED, min(MAX_SPEED, 8 * off))
        # A positive angle is to our left: then the right wheel must be faster. Negative velocities drive forwards.
        for motor, wanted in zip(self.motors, (speed - turn, speed + turn)):
            motor.setVelocity(-max(-MAX_SPEED, min(MAX_SPEED, wanted)))


Player().run()
