"""The team radio: once a step everybody tells where it is and where it sees the ball."""

import math
import struct

TIME_STEP = 32  # ms

# Number of the robot, its x and y, whether it sees the ball, the ball's x and y: 18 bytes of the 460 that fit.
MESSAGE = struct.Struct("<Bff?ff")


def pack_message(number, place, ball):
    """One message as bytes; ball is (x, y) or None."""
    return MESSAGE.pack(number, *place, ball is not None, *(ball or (0.0, 0.0)))


def unpack_message(data):
    """The opposite: (number, place, ball). None if the bytes are no message of ours."""
    if len(data) != MESSAGE.size:
        return None
    number, x, y, sees_ball, ball_x, ball_y = MESSAGE.unpack(data)
    return number, (x, y), (ball_x, ball_y) if sees_ball else None


class Team:
    """What the others told us."""

    def __init__(self, robot, number):
        self.number = number
        self.receiver = robot.getDevice("team receiver")
        self.emitter = robot.getDevice("team emitter")
        self.receiver.enable(TIME_STEP)
        self.heard = {}  # number -> [age in steps, place, ball]

    def tell(self, place, ball):
        self.emitter.send(pack_message(self.number, place, ball))

    def listen(self):
        for entry in self.heard.values():
            entry[0] += 1
        while self.receiver.getQueueLength() > 0:
            message = unpack_message(self.receiver.getBytes())  # getData() is text with messages v2.2
            self.receiver.nextPacket()
            if message is not None:
                number, place, ball = message
                self.heard[number] = [0, place, ball]

    def mates(self):
        """Places of the others, as far as we heard them in the last half second: {number: (x, y)}."""
        return {number: place for number, (age, place, _) in self.heard.items() if age < 15}

    def best_ball(self, own_place, own_ball):
        """Where the ball is: as we see it, else as the mate sees it that is nearest to it, else None."""
        if own_ball is not None:
            return own_ball
        sightings = [(math.dist(place, ball), ball) for age, place, ball in self.heard.values() if age < 3 and ball]
        return min(sightings)[1] if sightings else None
