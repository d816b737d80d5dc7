"""Getting free: notices that we are stuck, and does something about it."""

import math

STUCK_AFTER = 15  # steps (0.5 s) of turning wheels without moving
BACK_FOR = 16  # steps (0.5 s) of driving away
SPIN_FOR = 14  # steps (0.45 s) of turning on the spot: about a third of a turn
TOUCHING = 0.09  # m: nearer than this, the ball is at our front


class Escape:
    """Compares what the wheels did with where we are; when they disagree for long, we are stuck."""

    def __init__(self):
        self.slipping = 0
        self.steps_left = 0
        self.left = self.right = 0.0

    @property
    def active(self):
        return self.steps_left > 0

    def forget(self):
        self.slipping = 0
        self.steps_left = 0

    def watch(self, body):
        """Call once a step, before deciding."""
        if self.active:
            self.steps_left -= 1
            return
        # The wheels drove more than 2 mm, and we moved less than a quarter of it.
        if abs(body.rolled) > 0.002 and body.moved < 0.25 * abs(body.rolled):
            self.slipping += 1
        else:
            self.slipping = max(0, self.slipping - 3)
        if self.slipping > STUCK_AFTER:
            self.slipping = 0
            if body.ball is not None and math.dist(body.place, body.ball) < TOUCHING:
                self.spin(body)
            else:
                self.back_off(body)

    def spin(self, body):
        """We and somebody else press on the ball. Turn on the spot: our edge throws it out to the side.

        To the left or right? Where there is more room the ball can roll away.
        """
        self.steps_left = SPIN_FOR
        turn = 10 if body.sonar["right"] > body.sonar["left"] else -10
        self.left, self.right = turn, -turn

    def back_off(self, body):
        """We press on a wall or on a robot: drive to the end where there is more room, and turn a little."""
        self.steps_left = BACK_FOR
        speed = 7 if body.sonar["front"] > body.sonar["back"] else -7
        turn = 3 if body.sonar["left"] > body.sonar["right"] else -3
        self.left, self.right = speed + turn, speed - turn
