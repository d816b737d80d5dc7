"""Builds everything that never moves: floor, walls, goals, fixed obstacles.

Inner faces are where the scenario says; all walls are thickened outwards, away from the field. (Of the original's
walls of 1 cm, MuJoCo let one ball in eight through at 4 m/s.)
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import mujoco

from rcj_challenges.scenario.models.field import Box, Cylinder, FieldModel, Goal, Obstacle, Wall
from rcj_challenges.world import contact

WALL_THICKNESS_M = 0.1
"""Ten times the original's, all of it outside: a ball at 4 m/s moves 0.032 m in a sub-step."""

FIELD = "field/"
"""Prefix of the geoms of floor, walls and goals. Names of a scenario have no slash, so none can clash."""
FLOOR_GEOM = FIELD + "floor"
OBSTACLE = "obstacle/"
"""Prefix of the geom of a fixed obstacle."""


@dataclass(frozen=True)
class Block:
    """An upright box that cannot move: name of its geom, centre and half sizes along x, y and z, turn about z."""

    name: str
    centre_m: tuple[float, float, float]
    half_m: tuple[float, float, float]
    yaw_rad: float = 0.0

    @classmethod
    def between(cls, name: str, x_m: tuple[float, float], y_m: tuple[float, float], z_m: tuple[float, float]) -> Block:
        """Return the block that fills the given ranges of x, y and z."""
        middle = ((x_m[0] + x_m[1]) / 2, (y_m[0] + y_m[1]) / 2, (z_m[0] + z_m[1]) / 2)
        half = (abs(x_m[1] - x_m[0]) / 2, abs(y_m[1] - y_m[0]) / 2, abs(z_m[1] - z_m[0]) / 2)
        return cls(name, middle, half)


def add_floor(spec: mujoco.MjSpec, field: FieldModel) -> None:
    """Add the floor: an infinite plane, also outside the field. Only balls touch it: robots and obstacles glide."""
    floor = spec.worldbody.add_geom(
        name=FLOOR_GEOM,
        type=mujoco.mjtGeom.mjGEOM_PLANE,
        size=[0, 0, 1],
        contype=contact.ON_FLOOR,
        conaffinity=0,
        condim=3,
        group=contact.GROUP_FLOOR,
        priority=contact.PRIORITY_FLOOR,
    )
    set_surface(floor, *contact.ball_on_floor(field.friction))


def add_walls(spec: mujoco.MjSpec, field: FieldModel) -> None:
    """Add walls, corner walls and goals, or the border of the floor of a field without walls."""
    for block in wall_blocks(field.bounds):
        geom = _add_block(spec, block, field.friction)
        if not field.walls:
            geom.group = contact.GROUP_BORDER


def add_fixed_obstacle(spec: mujoco.MjSpec, name: str, obstacle: Obstacle, friction: float) -> None:
    """Add an obstacle that cannot be pushed, as the geom ``obstacle/NAME``."""
    if not isinstance(obstacle, Cylinder):
        _add_block(spec, _obstacle_block(OBSTACLE + name, obstacle), friction)
        return
    geom = spec.worldbody.add_geom(
        name=OBSTACLE + name,
        type=mujoco.mjtGeom.mjGEOM_CYLINDER,
        pos=[*obstacle.centre_m, obstacle.height_m / 2],
        size=[obstacle.radius_m, obstacle.height_m / 2, 0],
    )
    _make_fixture(geom, friction)


def wall_blocks(field: FieldModel) -> Iterator[Block]:
    """Yield the field's walls, corner walls and goals. Source: reference, section 1, table of parts."""
    half_x, half_y = field.width_m / 2, field.length_m / 2
    height = (0.0, field.wall_height_m)
    outer_x = half_x + WALL_THICKNESS_M
    for side, sign in (("left", -1), ("right", 1)):
        yield Block.between(
            f"{FIELD}wall_{side}",
            (sign * half_x, sign * outer_x),
            (-half_y - WALL_THICKNESS_M, half_y + WALL_THICKNESS_M),
            height,
        )
    for end, sign in (("positive_y", 1), ("negative_y", -1)):
        goal = next((goal for goal in field.goals.values() if goal.end == end), None)
        yield from _end_blocks(end, sign, goal, field)
    if field.cut_m > 0:
        yield from _corner_blocks(field)


def _end_blocks(end: str, sign: int, goal: Goal | None, field: FieldModel) -> Iterator[Block]:
    """The end wall, in two halves beside the goal if there is one, and the goal's walls.

    Beside the goal the end wall is as deep as the goal and so is its side wall, without a seam at the post; only the
    parts of the goal's walls above the end wall need separate blocks.
    """
    half_y, outer_x = field.length_m / 2, field.width_m / 2 + WALL_THICKNESS_M
    height = (0.0, field.wall_height_m)
    if goal is None:
        y_range = (sign * half_y, sign * (half_y + WALL_THICKNESS_M))
        yield Block.between(f"{FIELD}wall_{end}", (-outer_x, outer_x), y_range, height)
        return
    post, back = goal.width_m / 2, half_y + goal.depth_m
    outer_y = max(back, half_y + WALL_THICKNESS_M)
    for side, way in (("left", -1), ("right", 1)):
        yield Block.between(
            f"{FIELD}wall_{end}_{side}", (way * post, way * outer_x), (sign * half_y, sign * outer_y), height
        )
        if goal.wall_height_m > field.wall_height_m:
            yield Block.between(
                f"{FIELD}goal_{end}_{side}",
                (way * post, way * (post + WALL_THICKNESS_M)),
                (sign * half_y, sign * outer_y),
                (field.wall_height_m, goal.wall_height_m),
            )
    behind = (sign * back, sign * (back + WALL_THICKNESS_M))
    yield Block.between(f"{FIELD}goal_{end}_back", (-post, post), behind, (0.0, goal.wall_height_m))


def _corner_blocks(field: FieldModel) -> Iterator[Block]:
    """The corner walls at 45°: their ends and backs are buried in the other walls."""
    cut = field.corner_cut_m
    depth = cut / math.sqrt(2) + WALL_THICKNESS_M / 2
    half = (cut / math.sqrt(2) + WALL_THICKNESS_M / 2, depth / 2, field.wall_height_m / 2)
    for name, way_x, way_y in (
        ("right_positive_y", 1, 1),
        ("left_positive_y", -1, 1),
        ("left_negative_y", -1, -1),
        ("right_negative_y", 1, -1),
    ):
        middle_x, middle_y = field.width_m / 2 - cut / 2, field.length_m / 2 - cut / 2
        out = depth / 2 / math.sqrt(2)
        yield Block(
            f"{FIELD}corner_{name}",
            (way_x * (middle_x + out), way_y * (middle_y + out), field.wall_height_m / 2),
            half,
            -way_x * way_y * math.pi / 4,
        )


def _obstacle_block(name: str, obstacle: Box | Wall) -> Block:
    if isinstance(obstacle, Box):
        x, y = obstacle.centre_m
        half = (obstacle.size_m[0] / 2, obstacle.size_m[1] / 2, obstacle.height_m / 2)
        return Block(name, (x, y, obstacle.height_m / 2), half, obstacle.yaw_rad)
    (x0, y0), (x1, y1) = obstacle.from_m, obstacle.to_m
    return Block(
        name,
        ((x0 + x1) / 2, (y0 + y1) / 2, obstacle.height_m / 2),
        (math.hypot(x1 - x0, y1 - y0) / 2, obstacle.thickness_m / 2, obstacle.height_m / 2),
        math.atan2(y1 - y0, x1 - x0),
    )


def _add_block(spec: mujoco.MjSpec, block: Block, friction: float) -> mujoco.MjsGeom:
    geom = spec.worldbody.add_geom(
        name=block.name,
        type=mujoco.mjtGeom.mjGEOM_BOX,
        pos=list(block.centre_m),
        size=list(block.half_m),
        quat=[math.cos(block.yaw_rad / 2), 0, 0, math.sin(block.yaw_rad / 2)],
    )
    _make_fixture(geom, friction)
    return geom


def _make_fixture(geom: mujoco.MjsGeom, friction: float) -> None:
    geom.contype, geom.conaffinity = contact.FIXED, 0
    geom.group = contact.GROUP_FIXTURES
    geom.priority = contact.PRIORITY_SOLID
    set_surface(geom, contact.SOLIDS, friction)


def set_surface(geom: mujoco.MjsGeom, softness: contact.Softness, friction: float) -> None:
    """Give a geom its contact parameters. Friction against rolling and spinning on the spot is not used (condim 3)."""
    geom.condim = 3
    geom.solref = softness.solref
    geom.solimp = softness.solimp
    geom.friction = [friction, 0, 0]
