"""What stands on the field, as cameras see it: upright prisms and cylinders, and balls. Wheels are left out."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco

from rcj_challenges.core.colours import hex_colour
from rcj_challenges.scenario.kits import chassis_of
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.world import contact
from rcj_challenges.world.build_field import FIELD, OBSTACLE
from rcj_challenges.world.world import World

Point = tuple[float, float]

WALL_COLOUR = "#202428"
_USUAL_COLOUR = "#868e96"

_COAT_M = 1e-7
"""Thickness of the paint on a goal's inner sides."""


@dataclass(frozen=True)
class Prism:
    """An upright prism: its corners counter-clockwise and its range of heights in m, in the frame of its body.

    ``thing`` is the name of the robot or obstacle that it belongs to; empty: a part of the field. ``colour`` is
    ``#rrggbb``, here as in the others.
    """

    corners: tuple[Point, ...]
    low_m: float
    high_m: float
    colour: str
    body: int
    thing: str = ""


@dataclass(frozen=True)
class Disc:
    """An upright cylinder on the floor, by its geom."""

    geom: int
    radius_m: float
    height_m: float
    colour: str
    thing: str


@dataclass(frozen=True)
class Sphere:
    """A ball, by its body."""

    body: int
    radius_m: float
    colour: str
    thing: str


@dataclass(frozen=True)
class Standing:
    """All that stands on a field."""

    prisms: list[Prism]
    discs: list[Disc]
    balls: list[Sphere]


def colour_digits(colour: str) -> str:
    """Return a scenario's colour as ``#rrggbb``."""
    return hex_colour(colour) or _USUAL_COLOUR


def things_on_field(scenario: Scenario, roster: Roster, world: World) -> Standing:
    """Return all that stands on a field."""
    model = world.model
    box, cylinder = int(mujoco.mjtGeom.mjGEOM_BOX), int(mujoco.mjtGeom.mjGEOM_CYLINDER)
    prisms: list[Prism] = []
    discs: list[Disc] = []
    goals = {goal.end: colour_digits(goal.colour) for goal in scenario.field.goals.values()}
    for geom in range(model.ngeom):
        name = model.geom(geom).name
        thing = ""
        if name.startswith(FIELD) and model.geom_group[geom] != contact.GROUP_BORDER:
            kind, _, end = name.removeprefix(FIELD).partition("_")
            painted = (goals[e] for e in goals if end.startswith(e))
            colour = next(painted, WALL_COLOUR) if kind == "goal" else WALL_COLOUR
        elif (thing := name.removeprefix(OBSTACLE)) in scenario.obstacles:
            colour = colour_digits(scenario.obstacles[thing].colour)
        else:
            continue
        half_m, body = float(model.geom_size[geom, 2]), int(model.geom_bodyid[geom])
        x, y, z = model.geom_pos[geom].tolist()
        if model.geom_type[geom] == box:
            w, _, _, q = model.geom_quat[geom].tolist()
            cos, sin = w * w - q * q, 2 * w * q
            hx, hy = model.geom_size[geom, :2].tolist()
            corners = tuple(
                (x + cos * px - sin * py, y + sin * px + cos * py)
                for px, py in ((hx, hy), (-hx, hy), (-hx, -hy), (hx, -hy))
            )
            base_m = float(model.body_pos[body, 2]) if body else 0.0
            prisms.append(Prism(corners, base_m + z - half_m, base_m + z + half_m, colour, body, thing))
        elif model.geom_type[geom] == cylinder:
            radius_m, half_m, _ = model.geom_size[geom].tolist()
            discs.append(Disc(geom, radius_m, 2 * half_m, colour, thing))
    for goal in scenario.field.goals.values():
        prisms += _coats(scenario, goal.end, goals[goal.end])
    for name in roster.entities[: roster.robots]:
        chassis, body = chassis_of(scenario, name), int(model.body(name).id)
        colour = colour_digits(scenario.robots[name].colour)
        prisms += [Prism(outline, 0.0, chassis.height_m, colour, body, name) for outline in chassis.solids().values()]
    balls = [
        Sphere(int(model.body(name).id), ball.radius_m, colour_digits(ball.colour), name)
        for name, ball in scenario.balls.items()
    ]
    return Standing(prisms, discs, balls)


def _coats(scenario: Scenario, end: str, colour: str) -> list[Prism]:
    """Return the paint on the inner sides of the goal at an end; physically they are parts of the end wall."""
    goal = next(goal for goal in scenario.field.goals.values() if goal.end == end)
    sign = 1 if end == "positive_y" else -1
    near, far = sign * scenario.field.length_m / 2, sign * (scenario.field.length_m / 2 + goal.depth_m)
    y = (min(near, far), max(near, far))
    coats = []
    for way in (-1, 1):
        x = sorted((way * goal.width_m / 2, way * (goal.width_m / 2 - _COAT_M)))
        corners = ((x[1], y[1]), (x[0], y[1]), (x[0], y[0]), (x[1], y[0]))
        coats.append(Prism(corners, 0.0, goal.wall_height_m, colour, 0))
    return coats
