"""Sections ``zones``, ``gates``, ``spots``, ``groups`` and ``placements``: where things are and where they go."""

from typing import Annotated, Literal

from pydantic import Field

from rcj_challenges.rules.facing import Facing
from rcj_challenges.rules.fields import Colour, Name, Names, Point, Positive, Strict, described
from rcj_challenges.rules.mirror import Mirror
from rcj_challenges.rules.placement import Attempts, ClearanceM, NoiseM, Roll, WithoutRoom
from rcj_challenges.rules.places import At
from rcj_challenges.rules.refs import MEMBERS, ONE_ENTITY


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
    """All points beyond a line, on the side to which the normal points."""

    shape: Literal["half_plane"]
    through_m: Point = described(..., "a point of the line, [x, y] in m")
    normal: Point = described(..., "direction that points into the zone, [x, y]; its length does not matter")


Zone = Annotated[RectZone | CircleZone | PolygonZone | HalfPlaneZone, Field(discriminator="shape")]


class Gate(Strict):
    """A directed segment: crossing it from its right to its left, seen from ``from`` to ``to``, is ``forward``."""

    from_m: Point = described(..., "one post, [x, y] in m; relative to the anchor if there is one")
    to_m: Point = described(..., "the other post, [x, y] in m")
    anchor: Annotated[Name | None, ONE_ENTITY] = described(
        None, "an entity with which the gate moves and turns; left out: fixed"
    )


class Spot(Strict):
    """A named point."""

    x_m: float = described(..., "x in m")
    y_m: float = described(..., "y in m")


# --- where things go ------------------------------------------------------------------------------------------------


class Placing(Strict):
    """How one or more entities are put somewhere."""

    entity: Annotated[Names, MEMBERS] = described(
        ..., "what is put there: entities or groups; several are put one after the other"
    )
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
