"""Which shot brings the ball into the goal soonest? We try many aims between the posts."""

from driving.field import GOAL_LINE, is_free
from driving.shots import best_shot

# Not at the posts: a ball that hits a post does not go in.
AIMS = [(x / 100, GOAL_LINE) for x in range(-15, 16, 2)]


def best_goal_shot(position, heading, ball, aims=AIMS):
    """The quickest shot, or None if there is none (the ball lies at a wall)."""
    return best_shot(position, heading, ball, aims, is_free)
