"""The world that was played as a MuJoCo model with colours, floor markings and gates, for pictures only."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any

import mujoco

from rcj_challenges.scenario.models.field import FieldModel
from rcj_challenges.scenario.models.places import Gate, RectZone
from rcj_challenges.views.drawing.shapes import floor_of, floor_outline, forward_mark, goal_floor
from rcj_challenges.views.video.camera import FOV_DEG
from rcj_challenges.views.video.colours import DARK, GATE, GRASS, LINE, OUTSIDE, WALL, WHITE, Rgb, rgb
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.world.build import build_spec
from rcj_challenges.world.build_field import FIELD, OBSTACLE

LINE_M = 0.008
WALL_M = 0.012
_STRIPES = 8
_FLOOR_M = 0.01
_PAINT_M = 0.0004
"""Height of lines above the floor, so that surfaces in one plane do not flicker."""
_SAMPLES = 4
"""Samples for each pixel of a fine picture; videos do without, which takes half as long on a software GPU."""

Point = tuple[float, float]


def build_scene(footage: Footage, size: tuple[int, int], *, fine: bool) -> Any:
    """Return the compiled model. Gates that move with an entity are the mocap body ``ENTITY/gates``.

    Args:
        footage: what is shown.
        size: of the pictures, in pixels.
        fine: whether edges are smooth and shadows are cast.
    """
    spec = build_spec(footage.scenario, footage.roster)
    _set_light(spec, size, samples=_SAMPLES if fine else 0)
    if fine:  # a box as large as the ground would be speckled by its shadow
        _add_sky(spec)
    else:  # half as expensive as a sky on a software GPU
        _add_box(spec.worldbody, (0, 0, -3 * _FLOOR_M), (60, 60, _FLOOR_M), OUTSIDE)
    for geom in spec.geoms:
        if geom.name.startswith(FIELD):
            geom.rgba = [0, 0, 0, 0]  # walls of 10 cm and a floor without end
    _add_floor(spec, footage)
    for start, end, height_m, colour in _walls(footage.scenario.field):
        _add_bar(spec.worldbody, start, end, colour, width_m=WALL_M, height_m=height_m, outside=True, alpha=0.5)
    for name, obstacle in footage.scenario.obstacles.items():
        if name not in footage.roster.entities:
            _paint(spec.geom(OBSTACLE + name), rgb(obstacle.colour))
    for entity in footage.things["entities"]:
        _dress(spec, entity)
    _add_gates(spec, footage)
    return spec.compile()


def gates_by_anchor(footage: Footage) -> dict[int | None, list[Gate]]:
    """Return the gates that rules use, by the entity that they move with; None: on the floor."""
    found: dict[int | None, list[Gate]] = {}
    for gate in footage.things["gates"]:
        if gate["used"]:
            found.setdefault(gate["anchor"], []).append(footage.scenario.gates[gate["name"]])
    return found


def _add_gates(spec: Any, footage: Footage) -> None:
    for anchor, gates in gates_by_anchor(footage).items():
        body = spec.worldbody
        if anchor is not None:
            body = spec.worldbody.add_body(name=f"{footage.roster.entities[anchor]}/gates", mocap=True)
        for gate in gates:
            for start, end in (gate.from_m, gate.to_m), forward_mark(gate.from_m, gate.to_m):
                _add_bar(body, start, end, GATE)


def _set_light(spec: Any, size: tuple[int, int], samples: int) -> None:
    look = spec.visual
    look.global_.offwidth, look.global_.offheight = size
    look.global_.fovy = FOV_DEG
    look.quality.offsamples = samples
    look.quality.shadowsize = 4096
    # Few and flat faces are enough here: a fifth of a software GPU's time less.
    look.quality.numquads, look.quality.numslices = 1, 20
    look.headlight.ambient = [0.4] * 3
    look.headlight.diffuse = [0.22] * 3
    look.headlight.specular = [0.0] * 3
    look.map.znear, look.map.zfar = 0.01, 30
    spec.stat.extent, spec.stat.center = 2.0, [0, 0, 0]
    spec.worldbody.add_light(
        type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL, pos=[-1.0, 0.8, 3.0], dir=[0.3, -0.25, -1.0],
        diffuse=[0.45] * 3, specular=[0.1] * 3, castshadow=True,
    )  # fmt: skip


def _add_sky(spec: Any) -> None:
    sky = [part / 255 for part in OUTSIDE]
    spec.add_texture(
        type=mujoco.mjtTexture.mjTEXTURE_SKYBOX, builtin=mujoco.mjtBuiltin.mjBUILTIN_FLAT, rgb1=sky, rgb2=sky,
        width=16, height=96,
    )  # fmt: skip


def _add_floor(spec: Any, footage: Footage) -> None:
    """Add grass, goal floors and lines; zones end at the walls."""
    field = footage.scenario.field
    edges = [field.length_m * (k / _STRIPES - 0.5) for k in range(_STRIPES + 1)]
    for k, (low_m, high_m) in enumerate(pairwise(edges)):
        stripe = RectZone(shape="rect", y_min_m=low_m, y_max_m=high_m)
        _add_slab(spec, f"grass{k}", floor_outline(stripe, field), GRASS[k % 2])
    walls = floor_of(field)
    outlines = [(walls, LINE)]
    for name, goal in field.goals.items():
        corners = goal_floor(goal, field)
        r, g, b = (part * 6 // 10 for part in rgb(goal.colour))
        _add_slab(spec, f"{name}/floor", corners, (r, g, b))
        _add_bar(spec.worldbody, corners[0], corners[1], LINE)
    if field.goals:
        _add_bar(spec.worldbody, (-field.width_m / 2, 0.0), (field.width_m / 2, 0.0), LINE)
    zones = (zone for zone in footage.scenario.zones.values() if zone.drawn)
    outlines += [(floor_outline(zone, field), rgb(zone.colour) if zone.colour else LINE) for zone in zones]
    for outline, colour in outlines:
        for start, end in zip(outline, [*outline[1:], *outline[:1]], strict=True):
            _add_bar(spec.worldbody, start, end, colour)


def _walls(field: FieldModel) -> Iterator[tuple[Point, Point, float, Rgb]]:
    """Yield the inner faces of walls and goals, clockwise, with height and colour."""
    goals = [(goal, goal_floor(goal, field)) for goal in field.goals.values()]
    corners = floor_of(field)
    for start, end in zip(corners, [*corners[1:], corners[0]], strict=True):
        here = next((one for one in goals if start[0] != end[0] and start[1] == end[1] == one[1][0][1]), None)
        if here is None:
            yield start, end, field.wall_height_m, WALL
            continue
        goal, (left, right, far_right, far_left) = here
        if end[0] < start[0]:
            left, right, far_right, far_left = right, left, far_left, far_right
        yield start, left, field.wall_height_m, WALL
        for one, other in pairwise((left, far_left, far_right, right)):
            yield one, other, goal.wall_height_m, rgb(goal.colour)
        yield right, end, field.wall_height_m, WALL


def _dress(spec: Any, entity: Mapping[str, Any]) -> None:
    """Colour an entity; a robot gets two eyes and a bar on its lid at the front."""
    name, colour = entity["name"], rgb(str(entity["colour"]))
    if entity["kind"] == "obstacle":
        _paint(spec.geom(name), colour)
    elif entity["kind"] == "ball":
        texture = spec.add_texture(
            name=name, type=mujoco.mjtTexture.mjTEXTURE_CUBE, builtin=mujoco.mjtBuiltin.mjBUILTIN_CHECKER,
            rgb1=[part / 255 for part in colour], rgb2=[0.75 + part / 1020 for part in colour], width=32, height=192,
        )  # fmt: skip
        spec.geom(name).material = _material(spec, texture.name)
        _paint(spec.geom(name), WHITE)
    else:
        _paint(spec.geom(f"{name}/cube"), colour)
        for wheel in ("left_wheel", "right_wheel"):
            _paint(spec.geom(f"{name}/{wheel}"), DARK)
        body, half_m, front = spec.body(name), entity["size_m"] / 2, entity["front"]
        _add_box(body, (front * half_m * 0.7, 0, half_m), (half_m * 0.15, half_m * 0.6, 0.001), WHITE)
        for y in (-0.42, 0.42):
            at_m = (front * half_m, y * half_m, half_m * 0.3)
            _add_box(body, at_m, (0.0012, half_m * 0.16, half_m * 0.16), WHITE)


def _add_slab(spec: Any, name: str, corners: Sequence[Point], colour: Rgb) -> None:
    """Add a piece of floor with convex corners."""
    mesh = spec.add_mesh(name=name)
    mesh.uservert = [part for x, y in corners for z in (-_FLOOR_M, 0.0) for part in (x, y, z)]
    _paint(spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name), colour)


def _add_bar(
    body: Any, start: Point, end: Point, colour: Rgb, *, width_m: float = LINE_M, height_m: float = _PAINT_M,
    outside: bool = False, alpha: float = 1.0,
) -> None:  # fmt: skip
    """Add a line on the floor, or a wall that stands on the left of it (``outside``)."""
    length_m = math.dist(start, end)
    if not length_m:
        return
    turn_rad = math.atan2(end[1] - start[1], end[0] - start[0])
    aside_m = width_m / 2 if outside else 0.0
    x_m = (start[0] + end[0]) / 2 - aside_m * math.sin(turn_rad)
    y_m = (start[1] + end[1]) / 2 + aside_m * math.cos(turn_rad)
    half_m = ((length_m + width_m) / 2, width_m / 2, height_m / 2)
    geom = _add_box(body, (x_m, y_m, height_m / 2), half_m, colour, alpha)
    geom.quat = [math.cos(turn_rad / 2), 0, 0, math.sin(turn_rad / 2)]


def _add_box(body: Any, centre_m: Sequence[float], half_m: Sequence[float], colour: Rgb, alpha: float = 1.0) -> Any:
    geom = body.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, pos=centre_m, size=half_m)
    _paint(geom, colour, alpha)
    return geom


def _material(spec: Any, texture: str) -> str:
    material = spec.add_material(name=f"{texture}/material")
    material.textures[mujoco.mjtTextureRole.mjTEXROLE_RGB] = texture
    return str(material.name)


def _paint(geom: Any, colour: Rgb, alpha: float = 1.0) -> None:
    geom.rgba = [*(part / 255 for part in colour), alpha]
