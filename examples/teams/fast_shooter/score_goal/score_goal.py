"""Sharp Angle: the robot that solves "The fast shooter".

The idea: the ball needs three seconds to roll into the goal, and then the referee waits for another. We use this time.
While the ball still rolls, we drive back to a waiting place in the middle, just behind the halfway line, and look
along the line. Wherever the referee puts the next ball, we only have to drive along the line (forwards or backwards),
turn by a quarter, and shoot.

One goal takes less than six seconds, so every tenth of a second counts:

* `shot.py` looks for the quickest of all possible shots,
* the folder `driving` drives it: it knows how the wheels slip, and where we are now (the packets are old),
* this file listens to the referee and decides what to do.
"""

import math
import struct

from controller import Robot
from driving.body import STEP_MS, Body
from driving.field import TOP_SPEED
from driving.moves import Drive, Stop, make_step, moves_to
from shot import best_goal_shot

# Behind the halfway line, so that the ball has room before our side, wherever it is put.
WAITING_PLACE = (0.0, -0.0755)

# Where to push a ball that cannot be shot into the goal, because it lies at a wall: away from there.
WAYS_OUT = [(0.0, 0.3), (0.0, -0.3), (0.5, 0.0), (-0.5, 0.0)]

PACKET_TIME = 0.064  # seconds from packet to packet
FASTEST_ROLL = 0.05  # metres from packet to packet; what jumps further was put there by the referee
SLOW = 0.1  # m/s; a ball that rolls faster is let alone


class Shooter:
    """Listens, thinks and drives."""

    def __init__(self):
        self.robot = Robot()
        self.receiver = self.robot.getDevice("receiver")
        self.receiver.enable(STEP_MS)
        self.body = Body(self.robot, steers=6)
        self.ball = None  # where it was in the newest packet
        self.ball_speed = (0.0, 0.0)
        self.waiting = True  # the goal pause
        self.planned_ball = None  # ball, speed and time at which we planned the shot; None if we plan none
        self.moves = [Stop()]

    def run(self):
        # The referee speaks every 64 ms, but we may set the motors every 32 ms. So we are more exact, and hear sooner.
        # The first packet comes after two steps. Until then we drive towards the halfway line: there the ball lies.
        self.body.command(TOP_SPEED, TOP_SPEED)
        while self.robot.step(STEP_MS) != -1:
            self.listen()
            if self.ball is not None:
                self.think()
                make_step(self.body, self.moves)
            else:
                self.body.command(TOP_SPEED, TOP_SPEED)

    def listen(self):
        """Read the newest packet, if there is one."""
        if self.receiver.getQueueLength() == 0:
            self.body.go_on()
            return
        while self.receiver.getQueueLength() > 0:
            packet = self.receiver.getData()
            self.receiver.nextPacket()
        y, x, heading, ball_y, ball_x, self.waiting = struct.unpack("ddddd?", packet)
        self.body.seen_at((x, y), heading)
        before, self.ball = self.ball, (ball_x, ball_y)
        if before is None or math.dist(before, self.ball) > FASTEST_ROLL:
            self.ball_speed = (0.0, 0.0)
        else:
            self.ball_speed = tuple((new - old) / PACKET_TIME for new, old in zip(self.ball, before))

    def think(self):
        """Decide where to go. Most of the time it is decided already, and there is nothing to do."""
        if self.planned_ball is not None:
            # The ball is not where it should be: we hit it (or it met something). This shot is over.
            if self.waiting or math.dist(self.ball, self.expected_ball()) > 0.03:
                self.planned_ball = None
                self.go_home()
        elif not self.waiting and math.hypot(*self.ball_speed) < SLOW and self.plan_shot():
            return
        elif len(self.moves) == 1 and not self.is_home():
            self.go_home()

    def plan_shot(self):
        """Plan the quickest shot. Returns False if there is none."""
        ball, now = self.ball, self.robot.getTime()
        shot = None
        for _ in range(3 if self.ball_speed != (0.0, 0.0) else 1):
            shot = self.shot_at(ball)
            if shot is None:
                return False
            # A ball that rolls will be further when we hit it; so we plan again, for there.
            ball = self.ball_after(shot.seconds_to_hit)
        self.planned_ball = self.ball, self.ball_speed, now
        self.moves = self.way_to(shot.run_up, shot.heading, Drive(shot.gear))
        return True

    def shot_at(self, ball):
        """The quickest shot at the goal; if there is none, one that brings the ball away from the wall."""
        place, heading = self.body.position, self.body.heading
        return best_goal_shot(place, heading, ball) or best_goal_shot(place, heading, ball, WAYS_OUT)

    def ball_after(self, seconds):
        """Where the ball rolls to, as far as the walls let it."""
        x, y = (place + seconds * speed for place, speed in zip(self.ball, self.ball_speed))
        return max(-0.629, min(0.629, x)), max(-0.729, min(0.729, y))

    def expected_ball(self):
        """Where the ball should be now if nobody has touched it since we planned the shot."""
        (x, y), (speed_x, speed_y), planned_at = self.planned_ball
        seconds = self.robot.getTime() - planned_at
        return x + seconds * speed_x, y + seconds * speed_y

    def way_to(self, point, heading, last):
        """The moves to a pose, and what to do there."""
        return moves_to(self.body.position, self.body.heading, point, heading, last, near=0.0015)

    def is_home(self):
        """Whether we are at the waiting place and look along the halfway line."""
        return math.dist(WAITING_PLACE, self.body.position) < 0.004 and abs(math.sin(self.body.heading)) < 0.01

    def go_home(self):
        """Back to the waiting place. Whether we look to the right or to the left there is all the same."""
        heading = 0.0 if math.cos(self.body.heading) > 0 else math.pi
        self.moves = self.way_to(WAITING_PLACE, heading, Stop())


Shooter().run()
