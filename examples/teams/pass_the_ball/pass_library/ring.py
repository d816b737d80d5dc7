"""The quarters, who plays in which, and where each of us passes the ball on.

The ball goes round in a ring: Y1 - Y2 - B2 - B1 - Y1 … The shorter the ring, the more rounds in two minutes; so we pass
near the middle of the field. But each quarter must be visited, so the corners of the ring lie a little inside.
"""

RING = ["Y1", "Y2", "B2", "B1"]
CORNERS = {"Y1": (-0.145, -0.245), "Y2": (0.145, -0.245), "B2": (0.145, 0.245), "B1": (-0.145, 0.245)}

# The borders of the quarters; between them there are strips in which no robot may be.
INNER_X, INNER_Y = 0.108, 0.202


def before(name):
    """From whom we get the ball."""
    return RING[RING.index(name) - 1]


def after(name):
    """To whom we pass it."""
    return RING[(RING.index(name) + 1) % len(RING)]


def is_in_quarter(name, point, margin):
    """Whether a point is inside the robot's quarter, at least so far from the inner borders (in metres)."""
    x, y = CORNERS[name]
    side_x, side_y = (1 if x > 0 else -1), (1 if y > 0 else -1)
    return side_x * point[0] > INNER_X + margin and side_y * point[1] > INNER_Y + margin


def can_stand(name, point):
    """Whether the robot can stand and turn there: inside its quarter, and away from the walls."""
    return is_in_quarter(name, point, 0.02) and abs(point[0]) < 0.594 and abs(point[1]) < 0.694
