"""Reads the devices and turns everything into one frame: OUR frame.

In our frame the own goal is always at (0, -0.75) and the other goal at (0, +0.75), whichever colour we play. That is
how the yellow team sees the field; for the blue team we turn the field by half a turn. So the rest of the program
never asks for the colour.
"""

import json
import math
import struct

TIME_STEP = 32  # ms

# The ball's centre is this much lower than the robot's centre, in metres.
HEIGHT_DIFFERENCE = 0.0166


def wrap(angle):
    """Bring an angle (rad) into the range from -pi to pi."""
    return math.atan2(math.sin(angle), math.cos(angle))


def ball_position(x, y, heading, direction, strength):
    """Where the ball is, from our place and what the ball receiver says.

    direction is (ahead, left, up), strength is 1 / distance².
    """
    flat = math.sqrt(max(1 / strength - HEIGHT_DIFFERENCE**2, 0.0))
    bearing = heading + math.atan2(direction[1], direction[0])
    return x + flat * math.cos(bearing), y + flat * math.sin(bearing)


class Senses:
    """What this robot knows by itself."""

    def __init__(self, robot):
        self.is_blue = robot.getName()[0] == "B"
        self.gps = robot.getDevice("gps")
        self.compass = robot.getDevice("compass")
        self.ball_receiver = robot.getDevice("ball receiver")
        self.referee = robot.getDevice("supervisor receiver")
        for sensor in (self.gps, self.compass, self.ball_receiver, self.referee):
            sensor.enable(TIME_STEP)
        self.x = 0.0
        self.y = 0.0
        self.heading = 0.0  # 0: along +x, pi/2: towards the other goal
        self.ball = None  # (x, y), or None when we do not see it
        self.waiting_for_kickoff = False

    def read(self):
        """Read everything once; call it after each step."""
        x, y, _ = self.gps.getValues()
        sine, cosine, _ = self.compass.getValues()
        heading = math.atan2(sine, cosine)
        if self.is_blue:
            x, y, heading = -x, -y, heading + math.pi
        self.x, self.y, self.heading = x, y, wrap(heading)

        self.ball = None
        while self.ball_receiver.getQueueLength() > 0:
            direction = self.ball_receiver.getEmitterDirection()
            strength = self.ball_receiver.getSignalStrength()
            self.ball = ball_position(self.x, self.y, self.heading, direction, strength)
            self.ball_receiver.nextPacket()

        while self.referee.getQueueLength() > 0:
            packet = self.referee.getBytes()
            self.referee.nextPacket()
            if len(packet) == 1:  # messages v2.1: one byte, true or false
                (self.waiting_for_kickoff,) = struct.unpack("?", packet)
            elif b"waiting_for_kickoff" in packet:  # messages v2.2: JSON text
                self.waiting_for_kickoff = json.loads(packet)["waiting_for_kickoff"]
