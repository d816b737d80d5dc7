"""Which of the seven formations do we see?

The lidar measures 360 distances around us. From our pose and the distance we get the point on the field that each ray
met. The rule sheet says where the obstacles can stand, so we only have to find out which formation explains our
points best: with its robots just there, where rays ended.

All in the attack frame: the goal under attack is at the top, at y = 0.75, whichever of the two it is.
"""

import math

# The middles of the three robots. Seen from the other goal left and right are exchanged: "all left" is "all right".
FORMATIONS = [
    [(-0.148, 0.7), (-0.042, 0.7), (0.063, 0.7)],  # all right
    [(-0.063, 0.7), (0.042, 0.7), (0.148, 0.7)],  # all left
    [(-0.148, 0.7), (-0.042, 0.7), (0.148, 0.7)],  # two right, one left
    [(-0.148, 0.7), (0.042, 0.7), (0.148, 0.7)],  # two left, one right
    [(-0.148, 0.7), (0.0, 0.489), (0.148, 0.7)],  # one each side, one in front
    [(-0.148, 0.489), (0.0, 0.7), (0.148, 0.489)],  # one behind, two in front
    [(-0.103, 0.55), (0.0, 0.55), (0.103, 0.55)],  # all in the middle, in front
]

MAX_RANGE = 3.0  # m
NEAR = 0.045  # a point belongs to an obstacle if it is not further from its middle than this, in x and in y


def points_before_goal(position, heading, ranges):
    """Where the lidar's rays ended, as far as that is in the region in which obstacles can stand."""
    points = []
    for index, distance in enumerate(ranges):
        if 0.0 < distance < MAX_RANGE:
            # Reading 0 looks ahead; they go on clockwise, one degree each.
            angle = heading - math.radians(index)
            x = position[0] + distance * math.cos(angle)
            y = position[1] + distance * math.sin(angle)
            if abs(x) < 0.21 and 0.43 < y < 0.745:
                points.append((x, y))
    return points


def formation_of(points):
    """The formation that explains most of the points."""

    def explained(formation):
        return sum(any(abs(x - a) < NEAR and abs(y - b) < NEAR for a, b in formation) for x, y in points)

    return max(FORMATIONS, key=explained)
