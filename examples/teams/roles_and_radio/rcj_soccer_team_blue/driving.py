"""From a place to go to the speeds of the two wheels."""

import math

MAX_SPEED = 10  # rad/s


def wrap(angle):
    """Bring an angle (rad) into the range from -pi to pi."""
    return math.atan2(math.sin(angle), math.cos(angle))


def wheels_to_point(x, y, heading, target_x, target_y, near=0.03):
    """Speeds of (left wheel motor, right wheel motor) that bring us to the target.

    The robot is a cube: it drives backwards as well as forwards. So we never turn by more than a quarter turn; if the
    target is behind us, we reverse. Nearer than `near` metres we slow down.

    "left wheel motor" sits on the robot's RIGHT: left faster than right turns us to the left.
    """
    distance = math.hypot(target_x - x, target_y - y)
    angle = wrap(math.atan2(target_y - y, target_x - x) - heading)
    direction = 1
    if abs(angle) > math.pi / 2:
        direction = -1
        angle = wrap(angle + math.pi)
    if distance < 0.005:
        return 0.0, 0.0
    turn = max(-MAX_SPEED, min(MAX_SPEED, 9 * angle))
    speed = MAX_SPEED * max(0.0, math.cos(angle)) ** 2 * min(1.0, distance / near)
    turn *= min(1.0, distance / near)
    # Both together may be too fast for the motors: make both smaller, so that the curve stays the same.
    too_fast = max(1.0, (speed + abs(turn)) / MAX_SPEED)
    speed, turn = direction * speed / too_fast, turn / too_fast
    return speed + turn, speed - turn
