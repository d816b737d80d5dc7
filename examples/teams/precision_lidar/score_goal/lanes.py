"""Which way past the obstacles is free, and how wide.

All in the attack frame: the goal under attack is at the top, at y = 0.75, whichever of the two it is.
"""

import math

from driving.field import BALL_RADIUS, GOAL_LINE, GOAL_POST, direction_of, distance_to_segment

# An obstacle is a robot like us, turned to the goal, with its wheels to the left and right.
HALF_WIDTH = 0.05
HALF_DEPTH = 0.0375

POSTS = [(-GOAL_POST, 0.75), (GOAL_POST, 0.75)]
AIMS = [x / 200 for x in range(-34, 35)]  # on the goal line
WIDE = 0.018  # m; with so much room on both sides of the ball we do not look for more
NARROW = 0.002  # m; with less we do not try

# How the side wall changes the speed of a ball that bounces off it (measured): away from the wall and along it.
BOUNCES, KEEPS = 0.46, 0.675
CUSHION = 0.65 - BALL_RADIUS


def room(start, end, formation):
    """How much room a ball has on a straight way, on the narrower side; 0 or less: it touches something."""
    smallest = min(distance_to_segment(post, start, end) for post in POSTS)
    steps = 60
    for step in range(steps, -1, -1):  # from the goal back: most ways that are no good end there
        y = start[1] + (end[1] - start[1]) * step / steps
        if (
            y <= 0.38 or smallest <= BALL_RADIUS
        ):  # nearer to us there are no obstacles; worse than no room does not count
            break
        x = start[0] + (end[0] - start[0]) * step / steps
        for middle_x, middle_y in formation:
            beside = max(0.0, abs(x - middle_x) - HALF_WIDTH)
            before = max(0.0, abs(y - middle_y) - HALF_DEPTH)
            smallest = min(smallest, math.hypot(beside, before))
    return smallest - BALL_RADIUS


def straight_direction(ball, formation):
    """The direction for a straight shot: the nearest wide way, else the widest one. None if all are too narrow."""
    rooms = {aim: min(WIDE, room(ball, (aim, GOAL_LINE), formation)) for aim in AIMS}
    best = max(AIMS, key=lambda aim: (rooms[aim], -abs(aim - ball[0])))
    return direction_of(ball, (best, GOAL_LINE)) if rooms[best] > NARROW else None


def cushion_direction(ball, formation):
    """The direction for a shot over a side wall, as in billiards. None if there is no wide way.

    The ball comes back slower across the wall than along it, so it leaves at another angle than it came.
    """
    best = (WIDE / 2, None)
    for side in (1, -1):
        for aim in AIMS:
            to_wall, from_wall = CUSHION - side * ball[0], CUSHION - side * aim
            slope = (GOAL_LINE - ball[1]) / (to_wall + KEEPS / BOUNCES * from_wall)
            bounce = (side * CUSHION, ball[1] + slope * to_wall)
            best = max(best, (room(bounce, (aim, GOAL_LINE), formation), math.atan2(slope, side)), key=lambda b: b[0])
    return best[1]
