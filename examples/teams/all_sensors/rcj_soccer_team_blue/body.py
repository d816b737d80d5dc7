"""The robot's body: all devices, read once a step, in OUR frame.

In our frame the own goal is at (0, -0.75) and the other goal at (0, +0.75), whichever colour we play; for blue we turn
the field by half a turn.
"""

import json
import math
import struct

TIME_STEP = 32  # ms
MAX_SPEED = 10  # rad/s
WHEEL_RADIUS = 0.02  # m
WHEEL_DISTANCE = 0.09  # m between the two wheels
HEIGHT_DIFFERENCE = 0.0166  # m: the ball's centre is so much lower than ours

# The sonars and the direction of each, in the robot's frame. Their names are true sides, unlike the motors'.
SONARS = {"front": 0.0, "left": math.pi / 2, "back": math.pi, "right": -math.pi / 2}
SONAR_FROM_CENTRE = 0.0385  # m from the robot's centre to where a sonar begins to measure


def wrap(angle):
    """Bring an angle (rad) into the range from -pi to pi."""
    return math.atan2(math.sin(angle), math.cos(angle))


def ball_position(x, y, heading, direction, strength):
    """Where the ball is, from our place, its direction (ahead, left, up) and the strength 1 / distance²."""
    flat = math.sqrt(max(1 / strength - HEIGHT_DIFFERENCE**2, 0.0))
    bearing = heading + math.atan2(direction[1], direction[0])
    return x + flat * math.cos(bearing), y + flat * math.sin(bearing)


def wall_distance(x, y, direction):
    """Distance in m to the wall of the field when we look from (x, y) in a direction; the goals count as wall."""
    distances = []
    for place, step, wall in ((x, math.cos(direction), 0.65), (y, math.sin(direction), 0.75)):
        if abs(step) > 1e-6:
            distances.append((math.copysign(wall, step) - place) / step)
    return max(0.0, min(distances))


class Body:
    """Devices in, numbers out; numbers in, wheels turn."""

    def __init__(self, robot):
        self.robot = robot
        name = robot.getName()
        self.is_blue = name[0] == "B"
        self.number = int(name[1])

        self.left_motor = robot.getDevice("left wheel motor")
        self.right_motor = robot.getDevice("right wheel motor")
        for motor in (self.left_motor, self.right_motor):
            motor.setPosition(float("inf"))
            motor.setVelocity(0.0)

        self.gps = robot.getDevice("gps")
        self.compass = robot.getDevice("compass")
        self.ball_receiver = robot.getDevice("ball receiver")
        self.referee = robot.getDevice("supervisor receiver")
        self.left_wheel = robot.getDevice("left wheel sensor")
        self.right_wheel = robot.getDevice("right wheel sensor")
        self.sonar_devices = {side: robot.getDevice("distancesensor " + side) for side in SONARS}
        sensors = [self.gps, self.compass, self.ball_receiver, self.referee, self.left_wheel, self.right_wheel]
        for sensor in sensors + list(self.sonar_devices.values()):
            sensor.enable(TIME_STEP)

        self.time = 0.0  # s since the half began
        self.place = (0.0, 0.0)
        self.heading = 0.0
        self.ball = None  # (x, y) when we see it
        self.waiting_for_kickoff = False
        self.lying = False  # tipped over?
        self.sonar = {}  # side -> metres; about 1.0 means: nothing near
        self.rolled = 0.0  # m that the wheels drove in the last step, forward positive
        self.moved = 0.0  # m that we really moved in the last step
        self._old_wheels = None
        self._old_place = None

    def step(self):
        """Wait for the next step and read everything. False when the match is over."""
        if self.robot.step(TIME_STEP) == -1:
            return False
        self.time = self.robot.getTime()
        self._read_pose()
        self._read_ball()
        self._read_referee()
        self._read_wheels()
        for side, device in self.sonar_devices.items():
            self.sonar[side] = device.getValue() / 1000
        return True

    def drive(self, left, right):
        """Set the motors, in rad/s. "left wheel motor" is on our right: left > right turns us to the left."""
        self.left_motor.setVelocity(max(-MAX_SPEED, min(MAX_SPEED, left)))
        self.right_motor.setVelocity(max(-MAX_SPEED, min(MAX_SPEED, right)))

    def robot_near(self, side, within):
        """Whether another robot stands on that side, nearer than `within` metres.

        The sonar sees walls and robots. We know where the walls are: what is clearly nearer is a robot. (The sonar
        is 5 % wrong now and then, and it hears nothing from a surface that stands oblique.)
        """
        expected = wall_distance(*self.place, self.heading + SONARS[side]) - SONAR_FROM_CENTRE
        return self.sonar[side] < within and self.sonar[side] < 0.7 * expected

    def _read_pose(self):
        x, y, _ = self.gps.getValues()
        sine, cosine, up = self.compass.getValues()
        heading = math.atan2(sine, cosine)
        if self.is_blue:
            x, y, heading = -x, -y, heading + math.pi
        self.place, self.heading = (x, y), wrap(heading)
        self.lying = abs(up) >= 0.5

    def _read_ball(self):
        self.ball = None
        while self.ball_receiver.getQueueLength() > 0:
            direction = self.ball_receiver.getEmitterDirection()
            strength = self.ball_receiver.getSignalStrength()
            self.ball = ball_position(*self.place, self.heading, direction, strength)
            self.ball_receiver.nextPacket()

    def _read_referee(self):
        while self.referee.getQueueLength() > 0:
            packet = self.referee.getBytes()
            self.referee.nextPacket()
            if len(packet) == 1:  # messages v2.1: one byte, true or false
                (self.waiting_for_kickoff,) = struct.unpack("?", packet)
            elif b"waiting_for_kickoff" in packet:  # messages v2.2: JSON text
                self.waiting_for_kickoff = json.loads(packet)["waiting_for_kickoff"]

    def _read_wheels(self):
        wheels = (self.left_wheel.getValue(), self.right_wheel.getValue())
        if self._old_wheels is not None and self._old_place is not None:
            turned = [new - old for new, old in zip(wheels, self._old_wheels)]
            self.rolled = WHEEL_RADIUS * sum(turned) / 2
            self.moved = math.dist(self.place, self._old_place)
        self._old_wheels, self._old_place = wheels, self.place
