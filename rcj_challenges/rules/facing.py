"""Which way something looks where it is put."""

from math import atan2, pi
from random import Random
from typing import Annotated, Literal

from pydantic import Field

from rcj_challenges.rules.base import Phrases, Scope
from rcj_challenges.rules.fields import Name, Point, Strict, Yes, described
from rcj_challenges.rules.phrasing import heading
from rcj_challenges.rules.refs import ANCHOR
from rcj_challenges.tracking.places import Board, CompiledFacing


class Towards(Strict):
    """Faces an entity, a spot or a point, as positioned after all placements of the tick."""

    towards: Annotated[Name | Point, ANCHOR] = described(..., "an entity, a spot, each, a draw's name, or [x, y] in m")


class RandomFacing(Strict):
    """Look anywhere, every direction equally likely."""

    random: Yes


Facing = Annotated[
    Literal["start", "keep"] | float | Towards | RandomFacing,
    Field(
        union_mode="left_to_right",
        description="start: its start yaw; keep: as it is; a yaw in rad; {towards: NAME}; {random: true}",
    ),
]


def compile_facing(facing: Facing, to: Scope, entity: int) -> CompiledFacing:
    """Return a function from a point to the yaw there, in rad."""
    start_yaw, state = to.start_of(entity).pose[2], to.state
    match facing:
        case Towards():
            target = to.anchor(facing.towards)

            def towards(board: Board, _entity: int, point: Point, _rng: Random) -> float:
                x, y = target().locate(board)
                here = (x, y) == point
                return start_yaw if here else atan2(y - point[1], x - point[0])

            return towards
        case RandomFacing():
            return lambda _board, _entity, _point, rng: rng.uniform(-pi, pi)
        case "keep":
            return lambda _board, whose, _point, _rng: state.poses[whose][2]
        case "start":
            return lambda _board, _entity, _point, _rng: start_yaw
        case _:
            yaw = float(facing)
            return lambda _board, _entity, _point, _rng: yaw


def facing_words(phrases: Phrases, facing: Facing) -> str:
    """Return the direction of something that is not that of its start: ``facing the ball``."""
    match facing:
        case "start":
            return ""
        case "keep":
            way = "the way it did before"
        case Towards():
            way = phrases.point(facing.towards)
        case RandomFacing():
            way = "a random way"
        case _:
            way = heading(facing)
    return f"facing {way}"
