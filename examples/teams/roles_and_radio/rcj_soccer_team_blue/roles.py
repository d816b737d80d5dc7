"""Who does what, and where to go for it. Everything is in OUR frame: own goal at -y, other goal at +y."""

import math

OTHER_GOAL = (0.0, 0.80)
OWN_GOAL = (0.0, -0.75)
GOALIE_LINE = -0.56  # the penalty area begins at -0.59; who stays in it too long is moved away

# Where striker and support look for the ball when nobody sees it.
WAITING_PLACES = {1: (0.0, GOALIE_LINE), 2: (0.3, 0.0), 3: (-0.3, 0.0)}


def clamp(value, lowest, highest):
    return max(lowest, min(highest, value))


def way_to_ball(place, ball):
    """How far we have to go to get behind the ball, in metres. A robot before the ball has to go around it."""
    extra = 0.25 if place[1] > ball[1] else 0.0
    return math.dist(place, ball) + extra


def choose_role(number, place, mates, ball, role):
    """`goalie`, `striker` or `support`.

    Both field players compute the same, from the same numbers, so they agree without asking. The present striker
    keeps the role if it is only a little worse (0.05 m): else the two would swap all the time.
    """
    if number == 1:
        return "goalie"
    other = 5 - number  # 2 <-> 3
    if ball is None or other not in mates:
        return "striker"
    bonus = 0.05 if role == "striker" else -0.05
    ours, theirs = way_to_ball(place, ball), way_to_ball(mates[other], ball)
    return "striker" if ours - bonus <= theirs else "support"


def place_for(role, number, place, ball, time):
    """The point (x, y) to drive to."""
    if role == "goalie":
        return goalie_place(place, ball, time)
    if ball is None:
        x, y = WAITING_PLACES[number]
        # Walk up and down: a robot that stands still is moved by the referee for lack of progress.
        return x, y + 0.1 * math.sin(time)
    if role == "striker":
        return striker_place(place, ball)
    return support_place(ball)


def goalie_place(place, ball, time):
    """On the line before the goal, where the way from the ball to the goal crosses it."""
    sway = 0.04 * math.sin(1.5 * time)  # never stand still for long
    if ball is None:
        return sway, GOALIE_LINE
    if math.dist(place, ball) < 0.15 and ball[1] > place[1] + 0.02:
        return ball  # near and before us: kick it away
    share = (GOALIE_LINE - OWN_GOAL[1]) / max(ball[1] - OWN_GOAL[1], 0.2)
    return clamp(ball[0] * share, -0.18, 0.18) + sway, GOALIE_LINE


def striker_place(place, ball):
    """Behind the ball first; then through it, to the goal."""
    # The unit vector from the ball to the other goal, and our place seen from the ball along and across it.
    length = math.dist(ball, OTHER_GOAL)
    goal_x, goal_y = (OTHER_GOAL[0] - ball[0]) / length, (OTHER_GOAL[1] - ball[1]) / length
    from_ball_x, from_ball_y = place[0] - ball[0], place[1] - ball[1]
    along = from_ball_x * goal_x + from_ball_y * goal_y  # negative: we are behind the ball
    across = from_ball_x * goal_y - from_ball_y * goal_x  # how far beside the line we are; positive: right of it

    if along < -0.03 and abs(across) < 0.035:
        return ball[0] + 0.2 * goal_x, ball[1] + 0.2 * goal_y  # shoot: drive through the ball
    if along > -0.05:
        # Beside or before the ball: go around it, on the side where we are, at 0.12 m.
        side = 1 if across > 0 else -1
        return (
            ball[0] - 0.10 * goal_x + side * 0.12 * goal_y,
            ball[1] - 0.10 * goal_y - side * 0.12 * goal_x,
        )
    # Behind the ball, but not on the line to the goal: go there. The farther off we are, the more room we need.
    behind = clamp(2.5 * abs(across), 0.08, 0.18)
    return ball[0] - behind * goal_x, ball[1] - behind * goal_y


def support_place(ball):
    """Behind the ball and a little to the middle, out of the striker's way."""
    side = -1 if ball[0] > 0 else 1
    return clamp(ball[0] + side * 0.2, -0.5, 0.5), clamp(ball[1] - 0.3, -0.45, 0.4)
