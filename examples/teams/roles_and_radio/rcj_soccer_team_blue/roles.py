"""Who does what, and where to go for it. Everything is in OUR frame: own goal at -y, other goal at +y."""

import math

from driving import wrap

OTHER_GOAL = (0.0, 0.80)
OWN_GOAL = (0.0, -0.75)
GOALIE_LINE = -0.56  # the penalty area begins at -0.59; who stays in it too long is moved away

BESIDE = 0.11  # m: how far from the ball's middle we pass it
ON_LINE = 0.035  # m: so far beside the line "ball - goal" our front still hits the ball

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
    # To and fro: who drives less than 0.5 m in 15 s is moved away for lack of progress.
    sway = 0.06 * math.sin(1.5 * time)
    if ball is None:
        return sway, GOALIE_LINE
    if math.dist(place, ball) < 0.15 and ball[1] > place[1] + 0.02:
        return ball  # near and before us: kick it away
    share = (GOALIE_LINE - OWN_GOAL[1]) / max(ball[1] - OWN_GOAL[1], 0.2)
    return clamp(ball[0] * share, -0.18, 0.18) + sway, GOALIE_LINE


def striker_place(place, ball):
    """A point to drive to, so that we hit the ball towards the other goal.

    Think of the line through the ball to the goal. Behind the ball and near that line, we drive along it: the ball flies
    where our front looks. Else we steer past the ball, to come round behind it: the farther we are from the line, the
    wider, but never wider than needed to miss the ball by BESIDE. This gives a smooth curve around the ball.
    """
    to_ball = math.atan2(ball[1] - place[1], ball[0] - place[0])
    to_goal = math.atan2(OTHER_GOAL[1] - ball[1], OTHER_GOAL[0] - ball[0])
    wrong_by = wrap(to_ball - to_goal)
    distance = math.dist(place, ball)
    beside = distance * math.sin(wrong_by)  # m from the line; positive: the line is on our left
    if abs(wrong_by) < math.radians(70) and abs(beside) < ON_LINE:
        direction = to_goal + 8 * beside
    else:
        room = math.asin(min(1.0, BESIDE / max(distance, 0.01)))
        direction = to_ball + clamp(1.5 * wrong_by, -room, room)
    return place[0] + 0.2 * math.cos(direction), place[1] + 0.2 * math.sin(direction)


def support_place(ball):
    """Close behind the ball, on the side of the middle: when the ball gets loose there, the support has it."""
    side = -1 if ball[0] > 0 else 1
    return clamp(ball[0] + side * 0.15, -0.5, 0.5), clamp(ball[1] - 0.17, -0.45, 0.5)
