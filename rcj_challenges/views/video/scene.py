"""The world that was played as a MuJoCo model with colours, floor markings and gates, for pictures only."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any

import mujoco
import numpy as np
from PIL import Image, ImageDraw

from rcj_challenges.scenario.models.field import FieldModel
from rcj_challenges.scenario.models.places import RectZone
from rcj_challenges.scenario.shapes import SPOT_M, at_start, floor_of, floor_outline, forward_mark, goal_floor
from rcj_challenges.views.palette import PALETTE, Rgb, rgb, text_on
from rcj_challenges.views.replay.things import zone_colour
from rcj_challenges.views.video.camera import FOV_RAD
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video.text import text_mask
from rcj_challenges.world.build import build_spec
from rcj_challenges.world.build_field import FIELD, OBSTACLE

FLOOR_BODY = "/floor"
"""After the name of an entity: the body with what moves with it on the floor, its shadow and its gates."""
LINE_M = 0.008
_RIM_M = (0.012, 0.008)
"""Width and height of the rim on a wall of glass."""
_GLASS = 0.34
_STRIPES = 8
_FLOOR_M = 0.01
_PAINT_M = 0.0004
"""Height of lines above the floor, so that surfaces in one plane do not flicker."""
_SHADOW_M = (0.0, 0.004, 0.008, 0.012, 0.016)
"""By how much the layers of a shadow are larger than the body: where all lie above each other it is darkest."""
_SHADOW_ALPHA = 0.085
_LID_PX = 128
_SAMPLES = 4
"""Samples for each pixel of a fine picture; videos do without, which takes half as long on a software GPU."""

Point = tuple[float, float]


def build_scene(footage: Footage, size: tuple[int, int], *, fine: bool) -> Any:
    """Return the compiled model for pictures of a size in pixels, with smooth edges if they are ``fine``."""
    spec = build_spec(footage.scenario, footage.roster)
    _set_light(spec, size, samples=_SAMPLES if fine else 0)
    _add_box(spec.worldbody, (0, 0, -3 * _FLOOR_M), (60, 60, _FLOOR_M), rgb(PALETTE["outside"]["light"]))
    for geom in spec.geoms:
        if geom.name.startswith(FIELD):
            geom.rgba = [0, 0, 0, 0]  # walls of 10 cm and a floor without end
    _add_floor(spec, footage)
    for start, end, height_m, colour in _walls(footage.scenario.field):
        _add_bar(spec.worldbody, start, end, colour, width_m=0.001, height_m=height_m, alpha=_GLASS)
        _add_bar(spec.worldbody, start, end, colour, width_m=_RIM_M[0], height_m=_RIM_M[1], z_m=height_m)
    for name, obstacle in footage.scenario.obstacles.items():
        if name not in footage.roster.entities:
            geom = spec.geom(OBSTACLE + name)
            _paint(geom, rgb(obstacle.colour))
            _add_shadow(spec.worldbody, geom.type, geom.size, geom.pos, geom.quat)
    for index, entity in enumerate(footage.things["entities"]):
        floor = spec.worldbody.add_body(name=entity["name"] + FLOOR_BODY, mocap=True)
        _dress(spec, entity, floor)
        _add_gates(footage, floor, index)
    _add_gates(footage, spec.worldbody, None)
    return spec.compile()


def _add_gates(footage: Footage, body: Any, anchor: int | None) -> None:
    """Add the gates that rules use and that move with an entity; None: that stand on the floor."""
    for gate in footage.things["gates"]:
        if gate["used"] and gate["anchor"] == anchor:
            for start, end in (gate["from_m"], gate["to_m"]), forward_mark(gate["from_m"], gate["to_m"]):
                _add_bar(body, start, end, rgb(PALETTE["gate"]))


def _set_light(spec: Any, size: tuple[int, int], samples: int) -> None:
    look = spec.visual
    look.global_.offwidth, look.global_.offheight = size
    look.global_.fovy = math.degrees(FOV_RAD)
    look.quality.offsamples = samples
    # Few and flat faces are enough here: a fifth of a software GPU's time less.
    look.quality.numquads, look.quality.numslices = 1, 20
    # Shade is never deep: a dark yellow is an olive green.
    look.headlight.ambient, look.headlight.diffuse, look.headlight.specular = [0.72] * 3, [0.08] * 3, [0.0] * 3
    look.map.znear, look.map.zfar = 0.01, 30
    spec.stat.extent, spec.stat.center = 2.0, [0, 0, 0]
    spec.worldbody.add_light(
        type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL, pos=[-1.0, 0.8, 3.0], dir=[0.3, -0.25, -1.0],
        diffuse=[0.25] * 3, specular=[0.0] * 3, castshadow=False,
    )  # fmt: skip


def _add_floor(spec: Any, footage: Footage) -> None:
    field, line = footage.scenario.field, rgb(PALETTE["line"])
    floor = field.bounds
    edges = [floor.length_m * (k / _STRIPES - 0.5) for k in range(_STRIPES + 1)]
    for k, (low_m, high_m) in enumerate(pairwise(edges)):
        stripe = RectZone(shape="rect", y_min_m=low_m, y_max_m=high_m)
        _add_slab(spec, f"grass{k}", floor_outline(stripe, floor), rgb(PALETTE["grass"][(k + 1) % 2]))
    outlines = [(floor_of(field), line)]
    for name, goal in field.goals.items():
        corners = goal_floor(goal, field)
        r, g, b = (part * 7 // 10 for part in rgb(goal.colour))
        _add_slab(spec, f"{name}/floor", corners, (r, g, b))
        _add_bar(spec.worldbody, corners[0], corners[1], line)
    if field.goals:
        _add_bar(spec.worldbody, (-field.width_m / 2, 0.0), (field.width_m / 2, 0.0), line)
    for name, zone in footage.scenario.zones.items():
        if zone.drawn:
            own = zone_colour(footage.scenario, name)
            outlines.append((floor_outline(at_start(zone, footage.scenario), floor), line if own is None else rgb(own)))
    for spot in footage.scenario.spots.values():
        if spot.drawn:
            disc, at = mujoco.mjtGeom.mjGEOM_CYLINDER, (spot.x_m, spot.y_m, _PAINT_M / 2)
            dot = spec.worldbody.add_geom(type=disc, pos=at, size=(SPOT_M, _PAINT_M / 2, 0))
            _paint(dot, line if spot.colour is None else rgb(spot.colour))
    for outline, colour in outlines:
        for start, end in zip(outline, [*outline[1:], *outline[:1]], strict=True):
            _add_bar(spec.worldbody, start, end, colour)


def _walls(field: FieldModel) -> Iterator[tuple[Point, Point, float, Rgb]]:
    """Yield the inner faces of walls and goals, clockwise, with height and colour."""
    if not field.walls:
        return
    grey = rgb(PALETTE["wall"])
    goals = [(goal, goal_floor(goal, field)) for goal in field.goals.values()]
    corners = floor_of(field)
    for start, end in zip(corners, [*corners[1:], corners[0]], strict=True):
        here = next((one for one in goals if start[0] != end[0] and start[1] == end[1] == one[1][0][1]), None)
        if here is None:
            yield start, end, field.wall_height_m, grey
            continue
        goal, (left, right, far_right, far_left) = here
        if end[0] < start[0]:
            left, right, far_right, far_left = right, left, far_left, far_right
        yield start, left, field.wall_height_m, grey
        for one, other in pairwise((left, far_left, far_right, right)):
            yield one, other, goal.wall_height_m, rgb(goal.colour)
        yield right, end, field.wall_height_m, grey


def _dress(spec: Any, entity: Mapping[str, Any], floor: Any) -> None:
    name, colour = entity["name"], rgb(str(entity["colour"]))
    if entity["kind"] == "obstacle":
        geom = spec.geom(name)
        _paint(geom, colour)
        _add_shadow(floor, geom.type, geom.size)
    elif entity["kind"] == "ball":
        texture = spec.add_texture(
            name=name, type=mujoco.mjtTexture.mjTEXTURE_CUBE, builtin=mujoco.mjtBuiltin.mjBUILTIN_CHECKER,
            rgb1=[part / 255 for part in colour], rgb2=[0.55 + part / 567 for part in colour], width=32, height=192,
        )  # fmt: skip
        spec.geom(name).material = _material(spec, texture.name)
        _paint(spec.geom(name), rgb("white"))
        _add_shadow(floor, mujoco.mjtGeom.mjGEOM_CYLINDER, [entity["radius_m"]])
    else:
        dark, body = rgb(PALETTE["dark"]), spec.body(name)
        half_m, top_m, front = entity["size_m"] / 2, entity["height_m"] / 2, entity["front"]
        for geom in body.geoms:
            _paint(geom, colour if geom.name == f"{name}/body" else dark)
        if spec.geom(f"{name}/body").type == mujoco.mjtGeom.mjGEOM_BOX:
            _add_box(body, (0, 0, -0.64 * top_m), (half_m + 0.0003, half_m + 0.0003, 0.36 * top_m), dark)
        else:
            half_m *= math.sqrt(0.5)  # a lid that a round body holds
        lid = spec.add_texture(
            name=f"{name}/lid", type=mujoco.mjtTexture.mjTEXTURE_2D, width=_LID_PX, height=_LID_PX, nchannel=3,
        )  # fmt: skip
        lid.data = _lid(str(entity["number"]), colour, front).tobytes()
        top = _add_box(body, (0, 0, top_m), (half_m * 0.99, half_m * 0.99, 0.0006), rgb("white"))
        top.material = _material(spec, lid.name)
        for y in (-0.4, 0.4):
            at_m = (front * half_m, y * half_m, top_m * 0.3)
            _add_box(body, at_m, (0.0015, half_m * 0.16, half_m * 0.16), rgb(PALETTE["mark"]))
        _add_shadow(floor, mujoco.mjtGeom.mjGEOM_BOX, [half_m, half_m])


def _lid(number: str, colour: Rgb, front: int) -> Any:
    """Return the picture of a robot's lid as MuJoCo lays it on a box: x to the right, y upwards.

    As on the replay page: the number reads well from behind, and a white arrow points to the front.
    """
    lid = Image.new("RGB", (_LID_PX, _LID_PX), colour)
    ImageDraw.Draw(lid).polygon([(40, 24), (88, 24), (64, 3)], fill=rgb(PALETTE["mark"]))
    mask = text_mask(number, 78, bold=True, max_width_px=_LID_PX * 0.8)
    mask = mask.crop(mask.getbbox())
    lid.paste(text_on(colour), ((_LID_PX - mask.width) // 2, 32 + (90 - mask.height) // 2), mask)
    return np.asarray(lid.rotate(-90 * front))


def _add_shadow(
    body: Any, kind: Any, size: Sequence[float], pos: Sequence[float] = (0, 0, 0), quat: Sequence[float] = (1, 0, 0, 0)
) -> None:
    """Add a soft shadow on the floor below a body: layers that grow."""
    for layer, more_m in enumerate(_SHADOW_M, 1):
        geom = body.add_geom(type=kind, pos=[*pos[:2], 2 * _PAINT_M + layer * 1e-5], quat=quat)
        flat = [length + more_m for length in (size[:1] if kind == mujoco.mjtGeom.mjGEOM_CYLINDER else size[:2])]
        geom.size = [*flat, 1e-5, 0.0][:3]
        _paint(geom, (0, 0, 0), _SHADOW_ALPHA)


def _add_slab(spec: Any, name: str, corners: Sequence[Point], colour: Rgb) -> None:
    mesh = spec.add_mesh(name=name)
    mesh.uservert = [part for x, y in corners for z in (-_FLOOR_M, 0.0) for part in (x, y, z)]
    _paint(spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name), colour)


def _add_bar(
    body: Any, start: Point, end: Point, colour: Rgb, *, width_m: float = LINE_M, height_m: float = _PAINT_M,
    z_m: float = 0.0, alpha: float = 1.0,
) -> None:  # fmt: skip
    length_m = math.dist(start, end)
    if not length_m:
        return
    turn_rad = math.atan2(end[1] - start[1], end[0] - start[0])
    middle_m = ((start[0] + end[0]) / 2, (start[1] + end[1]) / 2, z_m + height_m / 2)
    geom = _add_box(body, middle_m, ((length_m + width_m) / 2, width_m / 2, height_m / 2), colour, alpha)
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
