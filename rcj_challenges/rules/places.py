"""Where things go: the words of ``at``, facing, mirrors and kicks."""

from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, Tag

from rcj_challenges.rules.fields import Name, Names, NotNegative, Point, Strict, Yes, described
from rcj_challenges.rules.refs import ANCHOR, DRAW, FLAG, MOVING, SPOTS, Ref
from rcj_challenges.rules.values import CounterValue


class Start(Strict):
    """The entity's own start pose, with its noise."""

    start: Yes


class AtPoint(Strict):
    """A fixed point of the floor."""

    point: Point = described(..., "[x, y] in m")


class AtSpot(Strict):
    """A spot, by its name."""

    spot: Annotated[
        Name,
        Ref(
            "spot",
            frozenset({"spot"}),
            drawn=True,
            instead="beside what moves is {relative_to: NAME, offset_m: [0.1, 0]}",
            instead_of=MOVING,
        ),
    ] = described(..., "name of the spot, or of a draw that decides among spots")


class UniformIn(Strict):
    """A random point of a zone, or of several taken as one; every point equally likely."""

    uniform_in: Annotated[Names, Ref("zone", frozenset({"zone"}), groups=True)] = described(
        ..., "a bounded zone; with a list or group: in any of them"
    )


class OnLine(Strict):
    """A random point of a segment, every point equally likely."""

    on_line: tuple[Point, Point] = Field(..., strict=False, description="both ends, [[x, y], [x, y]] in m")


class Choice(Strict):
    """One of several spots or points, equally likely, or as a draw decided."""

    choice: Annotated[tuple[Name | Point, ...], Ref("spot", frozenset({"spot"}), groups=True, drawn=True)] = Field(
        ..., strict=False, min_length=1, description="spots, groups of spots, draws that decide among spots, or points"
    )


class NearestFree(Strict):
    """A random one of the nearest free spots."""

    nearest_free: Annotated[Names, SPOTS] = described(..., "spots, or a group of spots")
    to: Annotated[Name | Point | None, ANCHOR] = described(
        None, "the entity, spot or point to be near, each, or a draw's name; left out: the moved entity"
    )
    choose_among: int = described(1, "draw one of this many nearest", ge=1, le=100)
    clearance_m: NotNegative = described(
        0.08,
        "a spot is free when no robot's or ball's centre is within this, in m, not even that of what is put there, and "
        "that has room there",
    )


class FurthestFree(Strict):
    """The furthest free spot."""

    furthest_free: Annotated[Names, SPOTS] = described(..., "spots, or a group of spots")
    from_: Annotated[Name | Point | None, ANCHOR] = Field(
        None,
        alias="from",
        description="the entity, spot or point to be far from, each, or a draw's name; left out: the moved entity",
    )
    choose_among: int = described(1, "draw one of this many furthest", ge=1, le=100)
    clearance_m: NotNegative = described(
        0.08,
        "a spot is free when no robot's or ball's centre is within this, in m, not even that of what is put there, and "
        "that has room there",
    )


class RelativeTo(Strict):
    """Beside another entity or spot; of a ball itself, with a kick: it rolls on from where it is, another way."""

    relative_to: Annotated[Name, ANCHOR] = described(
        ..., "an entity or spot, each, or a draw's name: what that has decided"
    )
    offset_m: Point = described(
        (0.0, 0.0), "[x, y] from it in m; a mirror mirrors a spot with its offset, of an entity the offset only"
    )
    turns: bool = described(False, "True: the offset is in the entity's own frame, x forward, and no mirror changes it")


_AT_KEYS = (
    "point", "spot", "uniform_in", "on_line", "choice", "nearest_free", "furthest_free", "relative_to", "start",
)  # fmt: skip


def _which_at(value: Any) -> str | None:
    if isinstance(value, str):
        return "word"
    if isinstance(value, dict):
        return next((key for key in _AT_KEYS if key in value), None)
    return next((key for key in _AT_KEYS if hasattr(value, key)), None)


At = Annotated[
    Annotated[Literal["start"], Tag("word")]
    | Annotated[Start, Tag("start")]
    | Annotated[AtPoint, Tag("point")]
    | Annotated[AtSpot, Tag("spot")]
    | Annotated[UniformIn, Tag("uniform_in")]
    | Annotated[OnLine, Tag("on_line")]
    | Annotated[Choice, Tag("choice")]
    | Annotated[NearestFree, Tag("nearest_free")]
    | Annotated[FurthestFree, Tag("furthest_free")]
    | Annotated[RelativeTo, Tag("relative_to")],
    Discriminator(_which_at),
]


class Towards(Strict):
    """Look at an entity, a spot or a point: at where it is once all is put that is put in that tick."""

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


class Mirror(Strict):
    """Mirror place and aim (not the facing), always or while a flag is set: formations that change ends."""

    axis: Literal["x", "y", "both"] = described(..., "x: x becomes -x; y: y becomes -y; both")
    when: Annotated[Name | None, FLAG] = described(
        None, "a flag; mirrored if it is true when the action runs. Left out: always"
    )


MAX_KICK_MPS = 3
"""Up to what the walls are known to hold, with a margin (ADR 2)."""
_KickSpeed = Annotated[float, Field(gt=0, le=MAX_KICK_MPS)]


class DrawnSpeed(Strict):
    """The speed that a draw decided, when the ball is set down."""

    draw: Annotated[Name, DRAW] = described(..., "a draw whose values are speeds in m/s, over 0 and up to 3")


class Kick(Strict):
    """A ball rolls away from where it is put; what mirrors its place mirrors its aim too. In tests it stays there."""

    towards: At = described(..., "where it rolls to: any word of `at`; chance decides anew each time")
    speed_mps: (
        _KickSpeed | Annotated[tuple[_KickSpeed, _KickSpeed], Field(strict=False)] | DrawnSpeed | CounterValue
    ) = described(
        ...,
        "how fast it sets off, in m/s, over 0 and up to 3; [least, most]: every speed between equally likely; "
        "{draw: NAME}: what that has decided; {counter: NAME}: what that is when the ball is set down: more than 3 is "
        "3, and at 0 or less it lies still",
        union_mode="left_to_right",
    )


class MayKick(Strict):
    """What may set a ball rolling. Where it does not, its data is that of the time before there were kicks."""


# How something is put somewhere, whether a layout or a rule says so.
NoiseM = Annotated[Point, Field(description="half width of uniform noise on x and y, in m, 0 to 5")]
ClearanceM = Annotated[
    NotNegative, Field(description="smallest gap to the outline of any other body, in m; the field's walls are none")
]
Attempts = Annotated[
    int,
    Field(
        ge=1,
        le=10_000,
        description="how often a random place is drawn before giving up; what waits for room draws 4 on each further "
        "tick",
    ),
]
WithoutRoom = Annotated[
    Literal["retry", "stay"],
    Field(
        description="no room: retry on every tick in which the rule lives, without repeating events, or stay where it "
        "is; the log says which"
    ),
]
Roll = Annotated[Kick | None, Field(description="only balls: it rolls away from there; left out: it lies still")]
