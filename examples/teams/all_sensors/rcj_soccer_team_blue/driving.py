"""From a place to go to the speeds of the two wheels."""

import math

MAX_SPEED = 10  # rad/s


def wrap(angle):
    """Bring an angle (rad) into the range from -pi to pi."""
    return math.atan2(math.sin(angle), math.cos(angle))


def wheels_to_point(x, y, heading, target_x, target_y, full_speed=False):
    """Speeds of (left wheel motor, right wheel motor) that bring us to the target, forwards or backwards.

    The robot is the same in front and behind, so it never turns by more than a quarter turn. With full_speed we do
    not brake at the target: that is how one shoots.
    """
    distance = math.hypot(target_x - x, target_y - y)
    if distance < 0.004:
        return 0.0, 0.0
    angle = wrap(math.atan2(target_y - y, target_x - x) - heading)
    direction = 1
    if abs(angle) > math.pi / 2:
        direction, angle = -1, wrap(angle + math.pi)
    brake = 1.0 if full_speed else min(1.0, distance / 0.03)
    turn = brake * max(-MAX_SPEED, min(MAX_SPEED, 10 * angle))
    speed = direction * brake * MAX_SPEED * max(0.0, math.cos(angle)) ** 2
    # Both together may be too fast for the motors: make both smaller, so that the curve stays the same.
    too_fast = max(1.0, (abs(speed) + abs(turn)) / MAX_SPEED)
    return (speed + turn) / too_fast, (speed - turn) / too_fast
