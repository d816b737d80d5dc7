"""One player of the passing machine; all four run this same program, each in its own quarter.

A player waits at home, a little behind its corner of the ring, and looks so that its face is right for a usual pass.
When the ball comes, it corrects its heading, and drives a little ahead or back until the ball will meet it after a
run-up of 5 cm. Then it only waits for the right moment, drives through the ball, and goes home.

No model is perfect. So each player looks where its pass really went, and corrects the next one: it learns.
"""

import math
import struct

from controller import Robot
from driving.body import STEP, STEP_MS, Body
from driving.field import TOP_SPEED, TOUCHING, WHEEL_ARM, direction_of, point_at, wrap
from driving.moves import Drive, Stop, make_step, moves_to
from driving.shots import best_shot
from pass_library.ring import CORNERS, after, before, can_stand, is_in_quarter
from pass_library.touch import face_for, meeting

ROBOTS = ["B1", "B2", "Y1", "Y2"]  # as the packet lists them
PACKET_TIME = 0.064  # s from packet to packet
JUMP = 0.05  # m from packet to packet; what goes further was put there by the referee

USUAL_SPEED = 0.32  # m/s of a pass; only for where to wait
RUN_UP = 0.05  # m
STARTS = 0.03  # s that we lose while we get to full speed
FOLLOWS = 0.12  # s that we drive on after the touch: the ball is hit more than once
SLOW = 0.08  # m/s; a ball that is slower will not come, it must be fetched

FIRST_CORRECTION = -0.06  # rad; what most passes turned out to need
LEARNS = 0.5  # how much of an error we correct at once


class Player:
    """Listens, thinks and drives."""

    def __init__(self):
        self.robot = Robot()
        self.name = self.robot.getName()
        self.receiver = self.robot.getDevice("receiver")
        self.receiver.enable(STEP_MS)
        self.body = Body(self.robot)

        self.corner, self.target = CORNERS[self.name], CORNERS[after(self.name)]
        coming = direction_of(CORNERS[before(self.name)], self.corner)
        usual = (USUAL_SPEED * math.cos(coming), USUAL_SPEED * math.sin(coming))
        self.home_heading = wrap(face_for(usual, direction_of(self.corner, self.target)))
        self.home = point_at(self.corner, self.home_heading + math.pi, TOUCHING + RUN_UP)

        self.ball = None  # where it was in the newest packet
        self.velocity = (0.0, 0.0)  # of the ball, in m/s
        self.packet_age = 0  # steps
        self.is_steady = False  # whether the ball kept its velocity from packet to packet
        self.task = "home"  # or "strike" (a coming ball), or "fetch" (one that lies in our quarter)
        self.moves = [Stop()]
        self.strike_ends = 0.0
        self.face = 0.0
        self.fetched_ball = None  # where it was, its velocity, and when we planned to fetch it
        self.passed = None  # when we hit it, and the direction that we wanted
        self.correction = FIRST_CORRECTION

    def run(self):
        # The referee speaks every 64 ms, but we may set the motors every 32 ms.
        while self.robot.step(STEP_MS) != -1:
            self.listen()
            if self.ball is not None:
                self.learn()
                self.think()

    # --- what we know -------------------------------------------------------------------------------------------------

    def listen(self):
        """Read the newest packet, if there is one."""
        self.packet_age += 1
        if self.receiver.getQueueLength() == 0:
            self.body.go_on()
            return
        while self.receiver.getQueueLength() > 0:
            packet = self.receiver.getData()
            self.receiver.nextPacket()
        numbers = struct.unpack("ddd" * len(ROBOTS) + "dd?", packet)
        first = 3 * ROBOTS.index(self.name)
        # The packet's x is our y and the other way round: see driving/field.py.
        y, x, heading = numbers[first : first + 3]
        was_moved = math.dist(self.body.position, (x, y)) > JUMP
        self.body.seen_at((x, y), heading)
        old, self.ball = self.ball, (numbers[13], numbers[12])
        self.packet_age = 1
        if old is None or was_moved or math.dist(old, self.ball) > JUMP:
            # A new start: the referee has put everything back.
            self.velocity, self.is_steady, self.passed = (0.0, 0.0), False, None
            self.go_home()
            return
        velocity = tuple((new - before) / PACKET_TIME for new, before in zip(self.ball, old))
        self.is_steady = math.dist(velocity, self.velocity) < 0.004
        self.velocity = velocity

    def ball_in(self, seconds):
        """Where the ball will be."""
        time = self.packet_age * STEP + seconds
        return self.ball[0] + time * self.velocity[0], self.ball[1] + time * self.velocity[1]

    def learn(self):
        """Look where our pass went, and correct the next one."""
        if self.passed is None or not self.is_steady:
            return
        hit_at, wanted = self.passed
        if self.robot.getTime() > hit_at + 0.3:
            error = wrap(math.atan2(self.velocity[1], self.velocity[0]) - wanted)
            if abs(error) < 0.3:  # else it was something else, not our aim
                self.correction += LEARNS * error
            self.passed = None

    # --- what we do ---------------------------------------------------------------------------------------------------

    def think(self):
        if self.task == "strike":
            self.strike()
            return
        if self.task == "fetch":
            x, y, velocity_x, velocity_y, planned_at = self.fetched_ball
            time = self.robot.getTime() - planned_at
            if math.dist(self.ball, (x + time * velocity_x, y + time * velocity_y)) > 0.03:
                self.go_home()  # it is not where it should be: we have hit it
        elif self.is_steady:
            is_slow = math.hypot(*self.velocity) < SLOW
            if is_slow and is_in_quarter(self.name, self.ball, -0.06):
                self.fetch()
            elif len(self.moves) == 1:  # at home
                if not is_slow and self.receive():
                    return
                if math.dist(self.body.position, self.home) > 0.008:
                    self.go_home()
        make_step(self.body, self.moves)

    def go_home(self):
        self.task = "home"
        self.moves = moves_to(self.body.position, self.body.heading, self.home, self.home_heading, Stop())

    def receive(self):
        """Prepare for a ball that comes, and strike in time. Returns False if it does not come to us."""
        body = self.body
        place = self.corner
        for _ in range(2):  # the face depends on the place where we meet, and the place on the face
            wanted = direction_of(place, self.target)
            face = face_for(self.velocity, wanted - self.correction)
            meet = meeting(self.ball_in(0.0), self.velocity, body.position, face, TOUCHING)
            if meet is None:
                return False
            way, time = meet
            place = self.ball_in(time)
        if not (0.0 < time < 2.5 and abs(way) < 0.25):
            return False
        off = wrap(face - body.heading)
        if time - way / TOP_SPEED - STARTS < STEP / 2 and way > 0.005 and abs(off) < 0.2:
            now = self.robot.getTime()
            self.task, self.face, self.strike_ends = "strike", face, now + time + FOLLOWS
            self.passed = now + time, wanted
            self.strike()
            return True
        spin = max(-3.0, min(3.0, off / STEP / 2))
        speed = max(-0.15, min(0.15, (way - RUN_UP) / STEP / 3)) * math.cos(off)
        if speed > 0 and not is_in_quarter(self.name, point_at(body.position, body.heading, 0.02), 0.03):
            speed = 0.0
        body.command(speed - spin * WHEEL_ARM, speed + spin * WHEEL_ARM)
        return True

    def strike(self):
        """Full speed ahead, through the ball; but never out of our quarter."""
        body = self.body
        if self.robot.getTime() > self.strike_ends or not is_in_quarter(self.name, body.position, 0.02):
            self.go_home()
            make_step(body, self.moves)
            return
        off = max(-0.05, min(0.05, 12 * wrap(self.face - body.heading) * WHEEL_ARM))
        slower = TOP_SPEED - 2 * abs(off)
        body.command(*((slower, TOP_SPEED) if off > 0 else (TOP_SPEED, slower)))

    def fetch(self):
        """Shoot a ball that lies, or rolls slowly, in our quarter."""
        body, ball, shot = self.body, self.ball, None
        for _ in range(3):  # it will have rolled on when we get there
            shot = best_shot(
                body.position, body.heading, ball, [self.target], lambda place: can_stand(self.name, place)
            )
            if shot is None:
                return
            ball = self.ball_in(shot.seconds_to_hit)
        self.task = "fetch"
        self.fetched_ball = (*self.ball, *self.velocity, self.robot.getTime())
        self.moves = moves_to(body.position, body.heading, shot.run_up, shot.heading, Drive(shot.gear))
