"""Sections ``zones``, ``gates``, ``spots``, ``groups`` and ``placements``: where things are and where they go."""

from typing import Annotated, Literal

from pydantic import Field

from rcj_challenges.rules.fields import Colour, Name, Names, Point, Positive, Strict, described
from rcj_challenges.rules.placement import Placement
from rcj_challenges.rules.places import At
from rcj_challenges.rules.refs import MEMBERS, MOVING, ONE_ENTITY, Ref


class _Drawn(Strict):
    drawn: bool = described(False, "True: pictures show it on the field: the outline of a zone, a spot as a dot")
    colour: Colour | None = described(
        None, "its colour in pictures: a CSS colour name or #rrggbb; if omitted: that of the field lines"
    )


class _Zone(_Drawn):
    inverted: bool = described(False, "True: everything except this shape")


class RectZone(_Zone):
    """A rectangle parallel to the axes; a side that is omitted is open. Points on an edge are outside."""

    shape: Literal["rect"]
    REQUIRES = (("x_min_m",), ("x_max_m",), ("y_min_m",), ("y_max_m",))

    x_min_m: float | None = described(None, "smallest x in m; if omitted: open")
    x_max_m: float | None = described(None, "largest x in m; if omitted: open")
    y_min_m: float | None = described(None, "smallest y in m; if omitted: open")
    y_max_m: float | None = described(None, "largest y in m; if omitted: open")


class CircleZone(_Zone):
    """A circle: all points closer to the centre than the radius."""

    shape: Literal["circle"]
    REQUIRES = (("centre_m",), ("anchor",))

    centre_m: Point | None = described(
        None, "centre, [x, y] in m; relative to the anchor if there is one, and then at it if omitted"
    )
    anchor: Annotated[Name | None, Ref("entity or spot", MOVING | {"spot"}, drawn=True)] = described(
        None,
        "a spot at which the circle sits, or an entity with which it moves and turns: things enter it by its moving, "
        "and while that is off the field nothing is in it; or a draw or role of such; if omitted: the circle is fixed",
    )
    radius_m: Positive = described(..., "radius in m")

    @property
    def middle_m(self) -> Point:
        """The centre, relative to the anchor if there is one."""
        return self.centre_m or (0.0, 0.0)


class PolygonZone(_Zone):
    """A simple polygon."""

    shape: Literal["polygon"]
    points_m: tuple[Point, ...] = described(..., "corners in order, [x, y] in m", min_length=3, max_length=100)


class HalfPlaneZone(_Zone):
    """All points beyond a line, on the side to which the normal points."""

    shape: Literal["half_plane"]
    through_m: Point = described(..., "a point on the line, [x, y] in m")
    normal: Point = described(..., "direction that points into the zone, [x, y]; its length does not matter")


Zone = Annotated[RectZone | CircleZone | PolygonZone | HalfPlaneZone, Field(discriminator="shape")]


class Gate(Strict):
    """A directed line segment. Looking from ``from_m`` to ``to_m``, crossing it from right to left is ``forward``."""

    from_m: Point = described(..., "one post, [x, y] in m; relative to the anchor if there is one")
    to_m: Point = described(..., "the other post, [x, y] in m")
    anchor: Annotated[Name | None, ONE_ENTITY] = described(
        None, "an entity with which the gate moves and turns; if omitted: the gate is fixed"
    )


class Spot(_Drawn):
    """A named point."""

    x_m: float = described(..., "x in m")
    y_m: float = described(..., "y in m")


# --- where things go ------------------------------------------------------------------------------------------------


class Placing(Placement):
    """How one or more entities are placed."""

    entity: Annotated[Names, MEMBERS] = described(..., "what is placed: entities or groups, one after the other")
    at: At = described(..., "where")


Layout = Annotated[
    tuple[Placing, ...],
    Field(min_length=1, description="an ordered list of placements; a later one may refer to an earlier"),
]
