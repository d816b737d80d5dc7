"""Gap Finder: the robot that solves "Is that an obstacle?".

The idea: three robots stand before the goal, and only the lidar sees them. But they stand in one of seven formations
that the rule sheet lists. So the robot stops for a moment, looks which formation it is, and then knows the gaps to the
millimetre. Through such a gap the ball must go straight, so it is hit with the middle of the face, out of a run-up in
which the robot corrects its heading. If there is no straight way, the ball takes the cushion, as in billiards. If there
is no way at all, or a shot has failed, the robot pushes an obstacle: that costs no point and brings a new ball.

While the ball rolls to one goal, the robot drives to the other side of the halfway line: there the next attack begins.

Everything is in the attack frame: the goal under attack is always at the top (at y = +0.75). When the attack goes to
the yellow goal, we turn the field by half a turn.

* `obstacles.py` finds the formation,
* `lanes.py` finds the way past it,
* the folder `driving` drives, and holds measures and geometry,
* this file reads the sensors and decides what to do.
"""

import math
import struct

from controller import Robot
from driving.body import STEP_MS, Body
from driving.field import HALF_ROBOT, TOUCHING, direction_of, distance_to_segment, nearest_on_segment, point_at, wrap
from driving.moves import Drive, Stop, Turn, make_step, moves_to, total_turn
from lanes import cushion_direction, straight_direction
from obstacles import formation_of, points_before_goal

WAITING_DISTANCE = 0.0775  # how far from the halfway line we wait for the ball: it must have room before our side
RUN_UP = 0.035  # the gap between our face and the ball before the last part of the way
AROUND_BALL = 0.078  # m; passing the ball nearer than this, we could touch it
LOOK_STEPS = 4  # the lidar turns ten times a second: after 4 steps of 32 ms it has looked everywhere
JUMP = 0.05  # metres from packet to packet; a ball that goes further was put there by the referee
PATIENCE_S = {"straight": 6.5, "cushion": 12.0, "push": 8.0}  # from the plan to the goal; else it has failed


class Shooter:
    """Senses, thinks and drives."""

    def __init__(self):
        self.robot = Robot()
        self.receiver = self.robot.getDevice("receiver")
        self.gps = self.robot.getDevice("gps")
        self.compass = self.robot.getDevice("compass")
        self.lidar = self.robot.getDevice("lidar")
        for sensor in (self.receiver, self.gps, self.compass, self.lidar):
            sensor.enable(STEP_MS)
        self.body = Body(self.robot)
        self.side = 1  # 1: the blue goal is under attack; -1: the yellow one, and the field is turned
        self.ball = None
        self.waiting = False  # the goal pause
        self.moves = [Stop()]
        self.task = "look"  # then "straight", "cushion" or "push"
        self.since = 0.0  # when the task began
        self.ball_lay = None  # where the ball was then
        self.is_done = False  # whether the ball is on its way

    def run(self):
        while self.robot.step(STEP_MS) != -1:
            self.sense()
            if self.ball is not None:
                self.think()
                make_step(self.body, self.moves)

    # --- senses -------------------------------------------------------------------------------------------------------

    def turned(self, point):
        """A point of the field in the attack frame."""
        return self.side * point[0], self.side * point[1]

    def sense(self):
        # Our x goes across the field and our y to the blue goal, as in a mathematics book. The devices of 2021 name
        # them differently: their first number is our y, their third one is our x.
        y, _, x = self.gps.getValues()
        cosine, _, sine = self.compass.getValues()
        heading = math.atan2(sine, cosine)
        self.body.is_at(self.turned((x, y)), heading if self.side > 0 else wrap(heading + math.pi))
        while self.receiver.getQueueLength() > 0:
            ball_y, ball_x, self.waiting = struct.unpack("dd?", self.receiver.getData())
            self.receiver.nextPacket()
            before, self.ball = self.ball, self.turned((ball_x, ball_y))
            if before is None or math.dist(before, self.ball) > JUMP:
                self.begin("look", [Stop()])  # a new ball: look where the obstacles are now

    def look(self):
        """The formation before the goal under attack. We also see which goal that is: the one with obstacles."""
        ranges = self.lidar.getRangeImage()
        points = points_before_goal(self.body.position, self.body.heading, ranges)
        position = (-self.body.position[0], -self.body.position[1])
        heading = wrap(self.body.heading + math.pi)
        others = points_before_goal(position, heading, ranges)
        if len(others) > len(points):
            self.side, points = -self.side, others
            self.body.is_at(position, heading)
            self.ball = (-self.ball[0], -self.ball[1])
        return formation_of(points)

    # --- decisions ----------------------------------------------------------------------------------------------------

    def begin(self, task, moves):
        """Begin a task with these moves."""
        self.task, self.moves, self.since = task, moves, self.robot.getTime()
        self.ball_lay, self.is_done = self.ball, False

    def think(self):
        busy_s = self.robot.getTime() - self.since
        if self.task == "look":
            if busy_s > LOOK_STEPS * STEP_MS / 1000 - 0.001 and not self.waiting:
                self.plan(self.look())
        elif busy_s > PATIENCE_S[self.task] and not self.waiting:
            self.push(self.look())  # it was no goal: ask for a new ball
        elif self.task == "push" and not self.waiting:
            self.blow()
        elif not self.is_done and (self.waiting or math.dist(self.ball, self.ball_lay) > 0.04):
            self.is_done = True
            self.wait_on_the_other_side()

    def plan(self, formation):
        """Plan how to score against this formation."""
        task, direction = "straight", straight_direction(self.ball, formation)
        if direction is None:
            task, direction = "cushion", cushion_direction(self.ball, formation)
        if direction is None:
            self.push(formation)
            return
        run_up = point_at(self.ball, direction + math.pi, TOUCHING + RUN_UP)
        beyond = point_at(self.ball, direction, 2.0)
        # Front and rear are the same to the ball: take the one that is quicker to get there.
        ways = [
            self.way_to(run_up, wrap(end), Drive(gear, beyond))
            for gear, end in ((1, direction), (-1, direction + math.pi))
        ]
        self.begin(task, min(ways, key=lambda moves: total_turn(self.body.heading, moves)))

    def way_to(self, point, heading, last):
        """The moves to a pose, round the ball if it lies in the way."""
        body, ball = self.body, self.ball
        if distance_to_segment(ball, body.position, point) > AROUND_BALL:
            return moves_to(body.position, body.heading, point, heading, last)
        # Over a point beside the ball, on the side on which we would have passed it.
        detour = point_at(ball, direction_of(ball, nearest_on_segment(ball, body.position, point)), 2 * AROUND_BALL)
        course = direction_of(body.position, detour)
        if abs(wrap(course - body.heading)) > math.pi / 2:
            course = wrap(course + math.pi)
        first = moves_to(body.position, body.heading, detour, course, None)[:-2]
        return first + moves_to(detour, course, point, heading, last)

    def push(self, formation):
        """Push an obstacle. It holds its wheels, so it gives way by a millimetre with each blow."""
        position = self.body.position

        def trouble(middle):
            # The nearest one; but not through the ball.
            way_clear = distance_to_segment(self.ball, position, middle) > AROUND_BALL
            return (0.0 if way_clear else 1.0) + math.dist(middle, position)

        self.obstacle = min(formation, key=trouble)
        before = (self.obstacle[0], self.obstacle[1] - 0.12)
        heading = math.copysign(math.pi / 2, math.sin(self.body.heading))
        moves = self.way_to(before, heading, Stop()) if trouble(self.obstacle) > 1 else [Stop()]
        self.begin("push", moves)
        self.place_before = None

    def blow(self):
        """Drive into the obstacle; when we stand, take a run-up and do it again."""
        body, before = self.body, self.place_before
        self.place_before = body.position
        stands = before is not None and math.dist(before, body.position) < 0.001
        touches = math.dist(body.position, self.obstacle) < 2 * HALF_ROBOT + 0.03
        if len(self.moves) > 1 or not (stands or isinstance(self.moves[0], Stop)):
            return
        heading = direction_of(body.position, self.obstacle)
        gear = 1 if abs(wrap(heading - body.heading)) < math.pi / 2 else -1
        if stands and touches and isinstance(self.moves[0], Drive):
            back = point_at(body.position, heading + math.pi, 0.03)
            self.moves = [Drive(-gear, back), Stop()]
        else:
            self.moves = [Turn(heading if gear > 0 else wrap(heading + math.pi)), Drive(gear)]

    def wait_on_the_other_side(self):
        """The next attack goes to the other goal: wait beyond the halfway line, and look along it."""
        heading = 0.0 if math.cos(self.body.heading) > 0 else math.pi
        place = (0.0, WAITING_DISTANCE)
        self.moves = moves_to(self.body.position, self.body.heading, place, heading, Stop())


Shooter().run()
