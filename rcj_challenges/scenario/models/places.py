"""Sections ``zones``, ``gates``, ``spots``, ``groups`` and ``placements``: where things are and where they go."""

from typing import Annotated, Any, Literal

from pydantic import Discriminator, Field, Tag

from rcj_challenges.scenario.models.base import (
    Colour,
    Name,
    Names,
    NotNegative,
    Point,
    Positive,
    Strict,
    Yes,
    described,
)
from rcj_challenges.scenario.models.state import CounterValue


class _Zone(Strict):
    inverted: bool = described(False, "True: everything but this")
    drawn: bool = described(False, "True: its outline is a line on the field in pictures")
    colour: Colour | None = described(
        None, "colour of its outline in pictures: a CSS colour name or #rrggbb; left out: that of lines"
    )


class RectZone(_Zone):
    """An upright rectangle; a side that is left out is open. All limits are strict."""

    shape: Literal["rect"]
    x_min_m: float | None = described(None, "smallest x in m; left out: open")
    x_max_m: float | None = described(None, "largest x in m; left out: open")
    y_min_m: float | None = described(None, "smallest y in m; left out: open")
    y_max_m: float | None = described(None, "largest y in m; left out: open")


class CircleZone(_Zone):
    """A circle: all points nearer to its centre than its radius."""

    shape: Literal["circle"]
    centre_m: Point = described(..., "centre, [x, y] in m")
    radius_m: Positive = described(..., "radius in m")


class PolygonZone(_Zone):
    """A simple polygon."""

    shape: Literal["polygon"]
    points_m: tuple[Point, ...] = Field(
        ..., strict=False, min_length=3, max_length=100, description="corners in order, [x, y] in m"
    )


class HalfPlaneZone(_Zone):
    """All points beyond a line, on the side that the normal shows to."""

    shape: Literal["half_plane"]
    through_m: Point = described(..., "a point of the line, [x, y] in m")
    normal: Point = described(..., "direction that points into the zone, [x, y]; its length does not matter")


Zone = Annotated[RectZone | CircleZone | PolygonZone | HalfPlaneZone, Field(discriminator="shape")]


class Gate(Strict):
    """A directed segment: crossing it from its right to its left, seen from ``from`` to ``to``, is ``forward``."""

    from_m: Point = described(..., "one post, [x, y] in m; relative to the anchor if there is one")
    to_m: Point = described(..., "the other post, [x, y] in m")
    anchor: Name | None = described(None, "an entity with which the gate moves and turns; left out: fixed")


class Spot(Strict):
    """A named point."""

    x_m: float = described(..., "x in m")
    y_m: float = described(..., "y in m")


# --- where things go ------------------------------------------------------------------------------------------------


class Start(Strict):
    """The entity's own start pose, with its noise."""

    start: Yes


class AtPoint(Strict):
    """A fixed point of the floor."""

    point: Point = described(..., "[x, y] in m")


class AtSpot(Strict):
    """A spot, by its name."""

    spot: Name = described(..., "name of the spot, or of a draw that decides among spots")


class UniformIn(Strict):
    """A random point of a zone, or of several taken as one; every point equally likely."""

    uniform_in: Names = described(..., "a bounded zone; with a list or group: in any of them")


class OnLine(Strict):
    """A random point of a segment, every point equally likely."""

    on_line: tuple[Point, Point] = Field(..., strict=False, description="both ends, [[x, y], [x, y]] in m")


class Choice(Strict):
    """One of several spots or points, equally likely, or as a draw decided."""

    choice: tuple[Name | Point, ...] = Field(
        ..., strict=False, min_length=1, description="spots, groups of spots, draws that decide among spots, or points"
    )


class NearestFree(Strict):
    """A random one of the nearest free spots."""

    nearest_free: Names = described(..., "spots, or a group of spots")
    to: Name | Point | None = described(
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

    furthest_free: Names = described(..., "spots, or a group of spots")
    from_: Name | Point | None = Field(
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

    relative_to: Name = described(..., "an entity or spot, each, or a draw's name: what that has decided")
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

    towards: Name | Point = described(..., "an entity, a spot, each, a draw's name, or [x, y] in m")


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
    when: Name | None = described(None, "a flag; mirrored if it is true when the action runs. Left out: always")


MAX_KICK_MPS = 3
"""Up to what the walls are known to hold, with a margin (ADR 2)."""
_KickSpeed = Annotated[float, Field(gt=0, le=MAX_KICK_MPS)]


class DrawnSpeed(Strict):
    """The speed that a draw decided, when the ball is set down."""

    draw: Name = described(..., "a draw whose values are speeds in m/s, over 0 and up to 3")


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


class Placing(MayKick):
    """How one or more entities are put somewhere."""

    entity: Names = described(..., "what is put there: entities or groups; several are put one after the other")
    at: At = described(..., "where")
    facing: Facing = described("start", "which way it looks afterwards")
    noise_m: NoiseM = (0.0, 0.0)
    mirror: Mirror | None = described(None, "mirror the place, and what a kick is aimed at")
    min_clearance_m: ClearanceM = 0.0
    max_attempts: Attempts = 100
    on_failure: WithoutRoom = "retry"
    kick: Roll = None


Layout = Annotated[
    tuple[Placing, ...],
    Field(strict=False, min_length=1, description="an ordered list of placements; a later one may refer to an earlier"),
]
