"""The team radio: every robot tells the others once a step where it is and where it sees the ball."""

import math
import struct

TIME_STEP = 32  # ms

# One message: number of the robot, its x and y, whether it sees the ball, the ball's x and y. "<" means: no gaps, and
# the same on every computer. 18 bytes; the radio carries 460 in each step.
MESSAGE = struct.Struct("<Bff?ff")

# What somebody said is forgotten after so many steps without a new message (about half a second).
FORGET_AFTER = 15


def pack_message(number, x, y, ball):
    """One message as bytes; ball is (x, y) or None."""
    ball_x, ball_y = ball if ball is not None else (0.0, 0.0)
    return MESSAGE.pack(number, x, y, ball is not None, ball_x, ball_y)


def unpack_message(data):
    """The opposite: (number, x, y, ball)."""
    number, x, y, sees_ball, ball_x, ball_y = MESSAGE.unpack(data)
    return number, x, y, (ball_x, ball_y) if sees_ball else None


class TeamRadio:
    """Sends our messages and remembers the newest of each team mate."""

    def __init__(self, robot, number):
        self.number = number
        self.receiver = robot.getDevice("team receiver")
        self.emitter = robot.getDevice("team emitter")
        self.receiver.enable(TIME_STEP)
        self.heard = {}  # number -> [age in steps, (x, y), ball or None]
        self.last_ball = None
        self.last_ball_age = 10**6

    def tell(self, x, y, ball):
        """Send one message. The others read it after their next step."""
        self.emitter.send(pack_message(self.number, x, y, ball))

    def listen(self):
        """Read all messages that came in."""
        for entry in self.heard.values():
            entry[0] += 1
        while self.receiver.getQueueLength() > 0:
            data = self.receiver.getBytes()  # bytes with every version of the messages; getData() may be text
            self.receiver.nextPacket()
            if len(data) != MESSAGE.size:
                continue  # not ours: never trust the radio
            number, x, y, ball = unpack_message(data)
            self.heard[number] = [0, (x, y), ball]

    def mates(self):
        """Places of the team mates that we heard lately: {number: (x, y)}."""
        return {number: place for number, (age, place, _) in self.heard.items() if age < FORGET_AFTER}

    def best_ball(self, own_place, own_ball):
        """The best that the team knows about the ball: (x, y), or None.

        What we see ourselves is newest. Else we trust the team mate who is nearest to the ball it sees. When nobody
        sees it, the last place is good for one more second.
        """
        seen = own_ball
        if seen is None:
            sightings = [(place, ball) for age, place, ball in self.heard.values() if age < 3 and ball]
            if sightings:
                seen = min(sightings, key=lambda s: math.dist(s[0], s[1]))[1]
        if seen is not None:
            self.last_ball, self.last_ball_age = seen, 0
        else:
            self.last_ball_age += 1
        return self.last_ball if self.last_ball_age < 30 else None
