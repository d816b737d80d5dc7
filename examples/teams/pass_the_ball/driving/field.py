"""The field, the robot and the ball in numbers, and a little geometry. Metres, radians, seconds.

The packets of 2021 call the direction to the blue goal `x` and the direction across the field `y`. We swap the two, so
that it is as in a mathematics book: our x goes across the field (to the right when we look at the blue goal), our y goes
to the blue goal, and the orientation is the angle from our x axis, counter-clockwise.
"""

import math

GOAL_LINE = 0.745  # the ball is in when its middle is beyond this y ...
GOAL_POST = 0.2  # ... between the posts at x = -0.2 and x = 0.2

BALL_RADIUS = 0.021
HALF_ROBOT = 0.0375  # from the robot's middle to its front and to its rear
CORNER = 0.054  # from the robot's middle to the outermost points of its wheels; its cube's corners reach 0.053
TOUCHING = HALF_ROBOT + BALL_RADIUS  # from middle to middle when the ball touches our front

TOP_SPEED = 0.2  # m/s, when both wheels turn at 10 rad/s
WHEEL_RADIUS = 0.02
WHEEL_ARM = 0.045  # from the robot's middle to each wheel


def wrap(angle):
    """Bring an angle into the range from -pi to pi."""
    return math.remainder(angle, 2 * math.pi)


def direction_of(start, end):
    """The direction from one point to another."""
    return math.atan2(end[1] - start[1], end[0] - start[0])


def point_at(start, direction, distance):
    """The point that we reach from `start` in this direction."""
    return (start[0] + distance * math.cos(direction), start[1] + distance * math.sin(direction))


def nearest_on_segment(point, start, end):
    """The point of the straight way from `start` to `end` that is nearest to another point."""
    way = (end[0] - start[0], end[1] - start[1])
    length = math.hypot(*way)
    if length == 0:
        return start
    share = ((point[0] - start[0]) * way[0] + (point[1] - start[1]) * way[1]) / length**2
    share = max(0.0, min(1.0, share))
    return (start[0] + share * way[0], start[1] + share * way[1])


def distance_to_segment(point, start, end):
    """How near the straight way from `start` to `end` comes to a point."""
    return math.dist(point, nearest_on_segment(point, start, end))


def is_free(point):
    """Whether the robot can stand and turn there without touching a wall."""
    return abs(point[0]) < 0.594 and abs(point[1]) < 0.694
