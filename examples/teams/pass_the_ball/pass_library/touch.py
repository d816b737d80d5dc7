"""How to hit a rolling ball so that it goes where we want.

The face of the robot is flat. A blow changes the ball's speed only at right angles to the face; along the face it
goes on as it came. For a robot at full speed: whatever the ball did before, it leaves the face with about 0.25 m/s at
right angles to it, and keeps about 0.89 of its speed along it. (Measured it is 0.26 to 0.28 and 0.82 to 1, by how the ball
comes. With these two numbers the passes went best.)

So if our face looks into the right direction, one touch is enough for a pass. The ball need not be stopped, and it
becomes faster than any ball that was hit at rest: up to 0.37 m/s.
"""

import math

AWAY = 0.25  # m/s
KEEPS = 0.89


def after_touch(velocity, face):
    """The ball's velocity after the blow of a face that looks and moves in the direction `face`."""
    cosine, sine = math.cos(face), math.sin(face)
    along = KEEPS * (cosine * velocity[1] - sine * velocity[0])
    return AWAY * cosine - along * sine, AWAY * sine + along * cosine


def face_for(velocity, wanted):
    """The direction for our face, so that a ball that comes with this velocity leaves in the direction `wanted`."""
    # The ball keeps some of its old motion, so the face must look further to the other side. How far? Halve the
    # interval until we know it.
    side = 1 if math.sin(math.atan2(velocity[1], velocity[0]) - wanted) > 0 else -1
    low, high = 0.0, math.radians(80)
    for _ in range(12):
        middle = (low + high) / 2
        out = after_touch(velocity, wanted - side * middle)
        too_far = side * math.sin(math.atan2(out[1], out[0]) - wanted) < 0
        low, high = (low, middle) if too_far else (middle, high)
    return wanted - side * (low + high) / 2


def meeting(ball, velocity, position, face, touching):
    """Where the ball meets us if we drive straight ahead in the direction `face`.

    Returns the way that we have to drive and the time until the ball is there; None if we never meet.
    """
    # position + (way + touching) * face  =  ball + time * velocity: two equations, two unknowns.
    cosine, sine = math.cos(face), math.sin(face)
    across = velocity[1] * cosine - velocity[0] * sine
    if abs(across) < 0.01:
        return None
    dx, dy = ball[0] - position[0], ball[1] - position[1]
    time = (dx * sine - dy * cosine) / across
    way = (dx + time * velocity[0]) * cosine + (dy + time * velocity[1]) * sine - touching
    return way, time
