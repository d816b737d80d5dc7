"""Who does what, and where to go for it. Everything in OUR frame: own goal at -y, other goal at +y."""

import math

from driving import wrap

OTHER_GOAL = (0.0, 0.80)
OWN_GOAL = (0.0, -0.75)
GOALIE_LINE = -0.56  # the penalty area begins at -0.59; who stays in it for 15 s is moved away
SPEED = 0.2  # m/s: how fast a robot drives
BESIDE = 0.11  # m: how far from the ball's middle we pass it, to come round behind it
CURVE = 1.5  # how sharp that curve is
ON_LINE = 0.035  # m: so far beside the line "ball - aim" our front still hits the ball

WAITING_PLACES = {1: (0.0, GOALIE_LINE), 2: (0.3, 0.0), 3: (-0.3, 0.0)}


def clamp(value, lowest, highest):
    return max(lowest, min(highest, value))


def time_to_ball(place, ball):
    """About how many seconds we need to get behind the ball."""
    detour = 0.25 if place[1] > ball[1] - 0.02 else 0.0
    return (math.dist(place, ball) + detour) / SPEED


def aim_for(ball):
    """The point in the other goal that we shoot at: the middle, or from the side the nearer half of the goal."""
    return clamp(0.4 * ball[0], -0.10, 0.10), OTHER_GOAL[1]


def attack(place, ball, ball_velocity, aim):
    """The direction (rad) to drive so that we hit the ball towards the aim.

    Think of the line through the ball to the aim. Two cases:

    * We are behind the ball and near that line: drive along it, through the ball. The ball flies where our front
      looks. If it is already rolling sideways, we look a little to the other side, to make up for it.
    * Else steer past the ball, to come round behind it: the farther we are from the line, the wider, but never wider
      than needed to miss the ball by BESIDE.
    """
    to_ball = math.atan2(ball[1] - place[1], ball[0] - place[0])
    to_aim = math.atan2(aim[1] - ball[1], aim[0] - ball[0])
    distance = math.dist(place, ball)
    wrong_by = wrap(to_ball - to_aim)
    beside = distance * math.sin(wrong_by)  # m from the line; positive: the line is on our left
    if abs(wrong_by) < math.radians(70) and abs(beside) < ON_LINE:
        sideways = ball_velocity[1] * math.cos(to_aim) - ball_velocity[0] * math.sin(to_aim)  # positive: to the left
        return to_aim + 8 * beside - clamp(sideways / SPEED, -0.8, 0.8)
    if distance > BESIDE:
        widest = math.asin(BESIDE / distance)
    else:
        widest = math.pi / 2 + 4 * (BESIDE - distance)  # too near: away from it a little
    return to_ball + math.copysign(min(CURVE * abs(wrong_by), widest), wrong_by)


def keep_on_field(point):
    """A robot's centre cannot be nearer to a wall than half a robot."""
    return clamp(point[0], -0.59, 0.59), clamp(point[1], -0.69, 0.72)


class Plan:
    """Decides once a step; remembers only who was the striker."""

    def __init__(self, number):
        self.number = number
        self.role = "support"
        self.go_round_left = True

    def decide(self, body, mates, tracker):
        """Return ((x, y) to drive to, whether at full speed)."""
        ball = tracker.place
        self.role = self.choose_role(body.place, mates, ball)
        if self.role == "goalie":
            return self.goalie(body, tracker)
        if ball is None:
            x, y = WAITING_PLACES[self.number]
            return (x, y + 0.1 * math.sin(body.time)), False  # stand still and the referee moves us
        if self.role == "support":
            return self.support(body, ball), False
        # Meet the ball where it will be when we are there.
        soon = tracker.place_in(min(0.6, max(0.0, math.dist(body.place, ball) - 0.08) / SPEED))
        direction = attack(body.place, soon, tracker.velocity, aim_for(soon))
        target = (body.place[0] + 0.2 * math.cos(direction), body.place[1] + 0.2 * math.sin(direction))
        return self.around_robots(body, keep_on_field(target), ball), True

    def choose_role(self, place, mates, ball):
        """Robot 1 is the goalie; of the others, who is sooner behind the ball is the striker."""
        if self.number == 1:
            return "goalie"
        other = mates.get(5 - self.number)
        if ball is None or other is None:
            return "striker"
        bonus = 0.3 if self.role == "striker" else -0.3  # s: do not swap for a trifle
        return "striker" if time_to_ball(place, ball) - bonus <= time_to_ball(other, ball) else "support"

    def goalie(self, body, tracker):
        """Between ball and goal; a ball on its way is met where it will cross our line."""
        sway = 0.06 * math.sin(1.5 * body.time)  # stand still and the referee moves us
        ball = tracker.place
        if ball is None:
            return (sway, GOALIE_LINE), False
        _, vy = tracker.velocity
        if math.dist(body.place, ball) < 0.16 and ball[1] > body.place[1] + 0.02:
            return ball, True  # kick it away
        if vy < -0.05 and ball[1] > GOALIE_LINE:
            x, _ = tracker.place_in(min(2.0, (ball[1] - GOALIE_LINE) / -vy))
            return (clamp(x, -0.2, 0.2), GOALIE_LINE), False
        share = (GOALIE_LINE - OWN_GOAL[1]) / max(ball[1] - OWN_GOAL[1], 0.2)
        return (clamp(ball[0] * share, -0.18, 0.18) + sway, GOALIE_LINE), False

    def support(self, body, ball):
        """Behind the ball and nearer to the middle: there most lost balls arrive."""
        side = -1 if ball[0] > 0 else 1
        sway = 0.05 * math.sin(body.time)
        return clamp(ball[0] + side * 0.14, -0.5, 0.5) + sway, clamp(ball[1] - 0.16, -0.42, 0.5)

    def around_robots(self, body, target, ball):
        """If a robot stands in our way and the ball does not, drive around it."""
        if math.dist(body.place, ball) < 0.2 or math.dist(body.place, target) < 0.15:
            return target  # it is about the ball: push
        angle = math.atan2(target[1] - body.place[1], target[0] - body.place[0]) - body.heading
        side = "front" if math.cos(angle) > 0 else "back"
        if not body.robot_near(side, within=0.12):
            return target
        # Turn to where there is more room.
        left, right = ("left", "right") if side == "front" else ("right", "left")
        turn = 1.0 if body.sonar[left] > body.sonar[right] else -1.0
        direction = math.atan2(target[1] - body.place[1], target[0] - body.place[0]) + turn
        return body.place[0] + 0.2 * math.cos(direction), body.place[1] + 0.2 * math.sin(direction)
