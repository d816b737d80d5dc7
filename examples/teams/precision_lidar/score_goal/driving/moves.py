"""Moves: drive straight, turn on the spot, stand still; and the quickest way from one pose to another.

A robot with two wheels is quickest when it only drives straight and turns on the spot.
"""

import math

from driving.body import look_ahead
from driving.field import TOP_SPEED, WHEEL_ARM, direction_of, wrap

# A move says which speeds it wants, how much of it is missing, and how much of that a way and a turn would bring.


class Drive:
    """Drive straight to a point, or (without a point) for ever. Gear 1 is forwards, -1 backwards."""

    def __init__(self, gear, point=None):
        self.gear = gear
        self.point = point

    def speeds(self, body):
        speed = self.gear * TOP_SPEED
        if self.point is None or self.missing(body) < 0.02:
            return speed, speed
        # Steer onto the point: one side keeps its speed, the other is a little slower.
        course = direction_of(body.position, self.point) + (0 if self.gear > 0 else math.pi)
        off = max(-0.1, min(0.1, body.steers * wrap(course - body.heading) * WHEEL_ARM))
        left, right = speed - off, speed + off
        too_fast = max(abs(left), abs(right)) / TOP_SPEED
        return left / too_fast, right / too_fast

    def missing(self, body):
        ahead = (self.point[0] - body.position[0], self.point[1] - body.position[1])
        return self.gear * (ahead[0] * math.cos(body.heading) + ahead[1] * math.sin(body.heading))

    def brings(self, way, turn):
        return self.gear * way


class Turn:
    """Turn on the spot to a heading."""

    def __init__(self, heading):
        self.heading = heading
        self.side = None  # 1 to the left, -1 to the right; once begun, we do not change our mind

    def begin(self, body):
        self.side = math.copysign(1, wrap(self.heading - body.heading))

    def speeds(self, body):
        side = self.side or math.copysign(1, wrap(self.heading - body.heading))
        return -side * TOP_SPEED, side * TOP_SPEED

    def missing(self, body):
        if self.side is None:
            self.begin(body)
        return self.side * wrap(self.heading - body.heading)

    def brings(self, way, turn):
        return self.side * turn


class Stop:
    """Stand still."""

    def speeds(self, body):
        return 0.0, 0.0


def moves_to(position, heading, point, end_heading, last, near=0.003):
    """The moves of the quickest way from one pose to another, and what to do there."""
    if math.dist(position, point) < near:
        return [Turn(end_heading), last]
    course = direction_of(position, point)
    turning = {
        gear: abs(wrap(start - heading)) + abs(wrap(end_heading - start))
        for gear, start in ((1, course), (-1, course + math.pi))
    }
    gear = min(turning, key=turning.get)
    start = wrap(course if gear > 0 else course + math.pi)
    # What is only a little to turn is done while driving.
    first = [Turn(start)] if abs(wrap(start - heading)) > 0.06 else []
    return [*first, Drive(gear, point), Turn(end_heading), last]


def total_turn(heading, moves):
    """How far a robot that looks in this direction turns in these moves."""
    total = 0.0
    for move in moves:
        if isinstance(move, Turn):
            total += abs(wrap(move.heading - heading))
            heading = move.heading
    return total


def make_step(body, moves):
    """Command the next step of these moves. Those that are done are taken off the list; the last one never is.

    A step is long: the robot turns by 8 degrees in it. When a move ends within a step, we mix: we command speeds
    between those of this move and those of the next one, so that we come out just right.
    """
    while len(moves) > 1:
        move, following = moves[0], moves[1]
        missing = move.missing(body)
        now, then = move.speeds(body), following.speeds(body)

        def mix(share):
            return [share * a + (1 - share) * b for a, b in zip(now, then)]

        def brought(share):
            return move.brings(*look_ahead(body.sides, [mix(share), then, then, then]))

        if brought(1) < missing:
            break  # a whole step of this move, and more to come
        moves.pop(0)
        if brought(0) < missing:
            low, high = 0.0, 1.0
            for _ in range(8):
                share = (low + high) / 2
                low, high = (share, high) if brought(share) < missing else (low, share)
            body.command(*mix(low))
            return
    body.command(*moves[0].speeds(body))


def make_step(body, moves):
    """Command the next step of these moves. Those that are done are taken off the list; the last one never is.

    A step is long: the robot turns by 8 degrees in it. When a move ends within a step, we mix: we command speeds
    between those of this move and those of the next one, so that we come out just right.
    """
    while len(moves) > 1:
        move, following = moves[0], moves[1]
        missing = move.missing(body)
        now, then = move.speeds(body), following.speeds(body)

        def mix(share):
            return [share * a + (1 - share) * b for a, b in zip(now, then)]

        def brought(share):
            return move.brings(*look_ahead(body.sides, [mix(share), then, then, then]))

        if brought(1) < missing:
            break  # a whole step of this move, and more to come
        moves.pop(0)
        if brought(0) < missing:
            low, high = 0.0, 1.0
            for _ in range(8):
                share = (low + high) / 2
                low, high = (share, high) if brought(share) < missing else (low, share)
            body.command(*mix(low))
            return
    body.command(*moves[0].speeds(body))
