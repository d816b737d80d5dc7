"""Sections ``match``, ``field``, ``balls`` and ``obstacles``: the scene of a match."""

from typing import Annotated, Literal

from pydantic import Field

from rcj_challenges.core.amounts import HALF, Noun
from rcj_challenges.rules.fields import Colour, DurationS, Point, Positive, Strict, described

FLOOR_BEYOND_M = 1.0
"""How far the floor reaches beyond the edges of a field without walls."""

_Called = Annotated[str, Field(pattern=r"^[a-z]+( [a-z]+)*$", max_length=24)]


class Match(Strict):
    """How many halves are played, how long they are, and whether the entrants change sides."""

    halves: int = described(1, "how many halves are played", ge=1, le=64)
    called: _Called | tuple[_Called, _Called] | None = described(
        None,
        "what a half is called in the terminal and on all pages: round; with its plural, if that takes more than an s: "
        "[inning, innings]; keywords and programs keep half",
    )
    half_s: DurationS | Annotated[tuple[DurationS, ...], Field(min_length=1)] = described(
        600.0, "simulated length of each half in s, or a list with one length per half"
    )
    swap_sides: bool = described(
        False,
        "whether the two entrants change sides after each half, as where they take turns; scores follow the team",
    )

    @property
    def period(self) -> Noun:
        """What a half is called."""
        if isinstance(self.called, tuple):
            return Noun(*self.called)
        return HALF if self.called is None else Noun(self.called, f"{self.called}s")


class Goal(Strict):
    """A goal: an opening in an end wall with a box of walls behind it. To count goals, also declare a zone there."""

    end: Literal["positive_y", "negative_y"] = described(..., "the end of the field at which it stands")
    colour: Colour = described(..., "its colour in pictures and the replay: a CSS colour name or #rrggbb")
    width_m: Positive = described(0.4, "inner width of the opening in m")
    depth_m: Positive = described(0.1, "distance from the end line to the back wall in m")
    wall_height_m: Positive = described(0.121, "height of the goal's walls above the floor in m")


class FieldModel(Strict):
    """The playing field with its walls and goals, measured between the inner faces of the walls, or of its edges.

    Without walls there is 1 m more floor on all sides. It ends at a border that stops everything, but is no wall: it is
    neither drawn nor sensed, and touching it is no touch.
    """

    width_m: Positive = described(1.3, "distance between the inner faces of the side walls (x) in m", le=10)
    length_m: Positive = described(1.5, "distance between the inner faces of the end walls (y) in m", le=10)
    walls: bool = described(True, "False: there are no walls, and no goals")
    wall_height_m: Positive = described(0.09, "height of the walls above the floor in m", le=1)
    corner_cut_m: float = described(
        0.06, "how far the 45° corner walls cut into the corner along each axis in m; 0: square corners", ge=0
    )
    friction: float = described(
        1.0,
        "Coulomb friction of the floor, of walls (at most 1 for balls) and between bodies that touch; at most "
        "0.1 between a ball and a robot or another ball, at the rims of wheels, and under movable obstacles",
        ge=0,
        le=2,
    )
    restitution: float = described(0.5, "share of its speed that a ball keeps when it hits a wall", ge=0, le=0.95)
    goals: dict[str, Goal] = described({}, "goals by name")

    @property
    def cut_m(self) -> float:
        """How far its corners are cut: they are square where there are no walls."""
        return self.corner_cut_m if self.walls else 0.0

    @property
    def reach_m(self) -> tuple[float, float]:
        """How far it reaches from its centre, along x and along y: its goals included."""
        deepest_m = max((goal.depth_m for goal in self.goals.values()), default=0.0)
        return self.width_m / 2, self.length_m / 2 + deepest_m

    @property
    def bounds(self) -> "FieldModel":
        """The field itself or, without walls, all of the floor as a larger one."""
        if self.walls:
            return self
        width_m, length_m = self.width_m + 2 * FLOOR_BEYOND_M, self.length_m + 2 * FLOOR_BEYOND_M
        return self.model_copy(update={"width_m": width_m, "length_m": length_m, "wall_height_m": 1.0})


class Ball(Strict):
    """A ball: a rolling sphere that sends infrared signals to the robots' ball receivers."""

    start_m: Point = described((0.0, 0.0), "position at the start of a half, [x, y] in m")
    radius_m: Positive = described(0.021, "radius in m", le=0.2)
    mass_kg: Positive = described(0.05, "mass in kg", le=5)
    colour: Colour = described("#e8590c", "colour in pictures: a CSS colour name or #rrggbb")
    emits: bool = described(True, "whether it sends infrared signals; robots receive those of all balls")
    slows_mps2: Positive | None = described(
        None, "deceleration while it rolls, in m/s²; if omitted: it does not slow down", le=5
    )


class _Obstacle(Strict):
    centre_m: Point = described(..., "position of its centre at the start of a half, [x, y] in m")
    height_m: Positive = described(0.09, "height above the floor in m", le=1)
    movable: bool = described(False, "whether robots can push it")
    mass_kg: Positive = described(0.5, "mass in kg, if movable", le=50)
    colour: Colour = described("#868e96", "colour in pictures: a CSS colour name or #rrggbb")


class Box(_Obstacle):
    """A box that stands on the floor."""

    shape: Literal["box"]
    size_m: Point = described(..., "full size along its own x and y in m")
    yaw_rad: float = described(0.0, "rotation about the vertical axis in rad, counter-clockwise")


class Cylinder(_Obstacle):
    """An upright cylinder that stands on the floor."""

    shape: Literal["cylinder"]
    radius_m: Positive = described(..., "radius in m", le=1)


class Wall(Strict):
    """A fixed wall between two points."""

    shape: Literal["wall"]
    from_m: Point = described(..., "one end, [x, y] in m")
    to_m: Point = described(..., "the other end, [x, y] in m")
    thickness_m: Positive = described(0.01, "thickness in m", le=0.5)
    height_m: Positive = described(0.09, "height above the floor in m", le=1)
    colour: Colour = described("#868e96", "colour in pictures: a CSS colour name or #rrggbb")


Obstacle = Annotated[Box | Cylinder | Wall, Field(discriminator="shape")]
