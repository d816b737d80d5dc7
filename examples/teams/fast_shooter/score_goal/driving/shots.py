"""Which way of shooting a ball that lies still is the quickest?

A robot with two wheels is quickest when it only drives straight and turns on the spot. So every shot has four parts:

    turn to the run-up point - drive there - turn to the aim - drive through the ball

and we can say how long each of them takes. There are many ways to do it: several aims, the run-up point near the
ball or further away, our front or our rear as the face that hits. We try them all and take the quickest.
"""

import math

from driving.field import (
    BALL_RADIUS,
    CORNER,
    TOP_SPEED,
    TOUCHING,
    WHEEL_ARM,
    direction_of,
    distance_to_segment,
    point_at,
    wrap,
)

# How much room there is between our face and the ball after the last turn: with less our corners would touch it.
RUN_UPS = [0.018 + 0.0015 * i for i in range(6)]

# How far we stay off the ball until we hit it.
ROOM = 0.0003

# How fast a ball leaves the middle of our face, in m/s (measured). Beside the middle it is slower, 0.23 m/s with 20 mm:
# the blow turns the robot away.
BALL_SPEED = 0.258


class Shot:
    """One way of shooting.

    direction: in which it will roll
    run_up: the point from which we drive through it
    heading: where our front looks then
    gear: 1 if our front hits, -1 if our rear does
    seconds: from now until the ball is there
    seconds_to_hit: from now until we hit the ball
    """

    def __init__(self, direction, run_up, gear, seconds_to_hit, seconds):
        self.direction = direction
        self.run_up = run_up
        self.gear = gear
        self.heading = direction if gear > 0 else wrap(direction + math.pi)
        self.seconds_to_hit = seconds_to_hit
        self.seconds = seconds


def turning_time(angle):
    """How long it takes to turn on the spot."""
    return abs(wrap(angle)) * WHEEL_ARM / TOP_SPEED


def time_to(position, heading, point, end_heading):
    """How long it takes to drive to a point, forwards or backwards, and to look into a direction there."""
    distance = math.dist(position, point)
    if distance < 0.002:
        return turning_time(end_heading - heading)
    course = direction_of(position, point)
    turning = min(turning_time(c - heading) + turning_time(end_heading - c) for c in (course, course + math.pi))
    return distance / TOP_SPEED + turning


def best_shot(position, heading, ball, aims, is_free):
    """The quickest shot at one of some points, or None if we can stand nowhere behind the ball."""
    best = None
    stay_off = min(CORNER + BALL_RADIUS, math.dist(position, ball)) - 0.001
    for aim in aims:
        direction = direction_of(ball, aim)
        for run_up in RUN_UPS:
            point = point_at(ball, direction + math.pi, TOUCHING + run_up)
            if math.dist(point, ball) < CORNER + BALL_RADIUS + ROOM or not is_free(point):
                continue  # no room to turn there
            if distance_to_segment(ball, position, point) < stay_off:
                continue  # the ball is in our way
            for gear in (1, -1):
                end_heading = direction if gear > 0 else direction + math.pi
                to_hit = time_to(position, heading, point, end_heading) + run_up / TOP_SPEED
                seconds = to_hit + math.dist(ball, aim) / BALL_SPEED
                if best is None or seconds < best.seconds:
                    best = Shot(direction, point, gear, to_hit, seconds)
    return best
