"""Remembers where the ball was, to know how fast it is and where it will be.

The ball rolls without slowing down until it meets something, so a straight line is a good guess for half a second.
"""

MEMORY = 6  # steps
JUMP = 0.15  # m in one step: nothing rolls so fast, somebody has put the ball elsewhere
FORGET_AFTER_S = 1.0


class BallTracker:
    """The team's view of the ball."""

    def __init__(self):
        self.sightings = []  # (time, x, y), oldest first

    def forget(self):
        self.sightings = []

    def update(self, time, ball):
        """Add what we know now; ball is (x, y) or None."""
        if ball is not None:
            if self.sightings:
                _, x, y = self.sightings[-1]
                if abs(ball[0] - x) + abs(ball[1] - y) > JUMP:
                    self.forget()
            self.sightings.append((time, *ball))
            self.sightings = self.sightings[-MEMORY:]
        elif self.sightings and time - self.sightings[-1][0] > FORGET_AFTER_S:
            self.forget()

    @property
    def place(self):
        """The last known place, or None."""
        return self.sightings[-1][1:] if self.sightings else None

    @property
    def velocity(self):
        """(x, y) in m/s; zero while we know too little."""
        if len(self.sightings) < 3:
            return 0.0, 0.0
        t0, x0, y0 = self.sightings[0]
        t1, x1, y1 = self.sightings[-1]
        if t1 <= t0:
            return 0.0, 0.0
        return (x1 - x0) / (t1 - t0), (y1 - y0) / (t1 - t0)

    def place_in(self, seconds):
        """Where the ball will be in so many seconds, kept inside the field; None if we do not know where it is."""
        if self.place is None:
            return None
        (x, y), (vx, vy) = self.place, self.velocity
        return max(-0.63, min(0.63, x + vx * seconds)), max(-0.73, min(0.73, y + vy * seconds))
