"""The things of a run as a MuJoCo model that is only looked at: nothing in it has mass, touches or moves by itself.

Sizes are the scenario's, as in the world that was played; walls are thin, so that they do not hide the field, and
what moves is placed by hand in every frame.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from itertools import pairwise
from typing import Any

import mujoco
import numpy as np
from PIL import Image

from rcj_challenges.scenario.models.field import Box, Cylinder
from rcj_challenges.views.drawing.shapes import floor_outline
from rcj_challenges.views.video.camera import WALL_M
from rcj_challenges.views.video.colours import (
    EDGE,
    GATE,
    GRASS,
    LINE,
    OUTSIDE,
    WALL,
    WHEEL,
    WHITE,
    Rgb,
    mixed,
    rgb,
    text_on,
)
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video.ground import LINE_M, gate_lines, moving_gate_lines
from rcj_challenges.views.video.lettering import Lettering

_STRIPES = 8
_LID_PX = 128
_FLOOR_M = 0.01
_PAINT_M = 0.0004
"""Lines stand this far above the floor: nothing that lies in one plane flickers."""

Point = tuple[float, float]
Point3 = tuple[float, float, float]


def solid_model(footage: Footage, size: tuple[int, int], samples: int, lettering: Lettering, *, shadows: bool) -> Any:
    """Return the compiled model; each entity is a mocap body of its name, the gates that move with it another.

    Args:
        footage: what is shown.
        size: of the pictures, in pixels.
        samples: for each pixel, against jagged edges; 0: one.
        lettering: for the numbers on the robots.
        shadows: whether real shadows are thrown; else robots get a dark patch under them.
    """
    spec = mujoco.MjSpec()
    spec.modelname = "video"
    look = spec.visual
    look.global_.offwidth, look.global_.offheight = size
    look.quality.offsamples = samples
    look.quality.shadowsize = 4096
    # Few and flat faces are enough for boxes under one directional light: a fifth of a software GPU's time less.
    look.quality.numquads = 1
    look.quality.numslices = 20
    look.headlight.ambient = [0.4, 0.4, 0.4]
    look.headlight.diffuse = [0.22, 0.22, 0.22]
    look.headlight.specular = [0.0, 0.0, 0.0]
    look.map.znear, look.map.zfar = 0.01, 30
    spec.stat.extent, spec.stat.center = 2.0, [0, 0, 0]
    spec.worldbody.add_light(
        type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL,
        pos=[-1.0, 0.8, 3.0],
        dir=[0.3, -0.25, -1.0],
        diffuse=[0.45, 0.45, 0.45],
        specular=[0.1, 0.1, 0.1],
        castshadow=True,
    )
    builder = _Builder(spec)
    _add_field(builder, footage)
    for name, obstacle in footage.scenario.obstacles.items():
        if name not in footage.roster.entities:
            _add_fixed(builder, obstacle)
    _add_surroundings(builder, shadows=shadows)
    for entity in footage.things["entities"]:
        _add_entity(spec, entity, lettering, patch=not shadows)
    for anchor, lines in moving_gate_lines(footage).items():
        gates = _Builder(spec, spec.worldbody.add_body(name=gates_of(footage.roster.entities[anchor]), mocap=True))
        for start, end in lines:
            gates.paint(start, end, GATE)
    return spec.compile()


def gates_of(entity: str) -> str:
    """Return the name of the body of the gates that move with an entity: on the floor, whatever its own one does."""
    return f"{entity}/gates"


class _Builder:
    """Adds boxes and lines to the world, where they never move, or to another body."""

    def __init__(self, spec: Any, body: Any = None) -> None:
        self.body = spec.worldbody if body is None else body
        self._spec = spec

    def slab(self, name: str, corners: list[Point], colour: Rgb) -> None:
        """Add a piece of floor with convex corners, its top at height 0."""
        mesh = self._spec.add_mesh(name=name)
        mesh.uservert = [part for x, y in corners for z in (-_FLOOR_M, 0.0) for part in (x, y, z)]
        _look(self.body.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name), colour)

    def sky(self, colour: Rgb) -> None:
        """Add a background of one colour."""
        self._spec.add_texture(
            type=mujoco.mjtTexture.mjTEXTURE_SKYBOX,
            builtin=mujoco.mjtBuiltin.mjBUILTIN_FLAT,
            rgb1=_share(colour),
            rgb2=_share(colour),
            width=16,
            height=96,
        )

    def box(self, centre: Point3, half: Point3, colour: Rgb, alpha: float = 1.0, yaw_rad: float = 0.0) -> None:
        turn = [math.cos(yaw_rad / 2), 0, 0, math.sin(yaw_rad / 2)]
        _look(self.body.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, pos=centre, size=half, quat=turn), colour, alpha)

    def bar(self, start: Point, end: Point, width_m: float, z_m: Point, colour: Rgb, alpha: float = 1.0) -> None:
        """Add an upright bar between two points of the floor, from one height to another."""
        (x1, y1), (x2, y2) = start, end
        half = (math.hypot(x2 - x1, y2 - y1) / 2 + width_m / 2, width_m / 2, (z_m[1] - z_m[0]) / 2)
        middle = ((x1 + x2) / 2, (y1 + y2) / 2, (z_m[0] + z_m[1]) / 2)
        self.box(middle, half, colour, alpha, math.atan2(y2 - y1, x2 - x1))

    def paint(self, start: Point, end: Point, colour: Rgb = LINE) -> None:
        """Add a line on the floor."""
        self.bar(start, end, LINE_M, (0.0, _PAINT_M), colour)


def _add_surroundings(builder: _Builder, *, shadows: bool) -> None:
    """Put one calm colour around the field.

    A software GPU is faster with a ground than with a sky, the more so if it comes after what hides most of it; but
    shadows on so large a ground are speckled.
    """
    if shadows:
        builder.sky(OUTSIDE)
    else:
        builder.box((0, 0, -_PAINT_M - _FLOOR_M), (60.0, 60.0, _FLOOR_M), OUTSIDE)


def _add_field(builder: _Builder, footage: Footage) -> None:
    field = footage.things["field"]
    w, h, cut = field["width_m"] / 2, field["length_m"] / 2, field["corner_cut_m"]
    for stripe in range(_STRIPES):
        low, high = (-h + 2 * h * k / _STRIPES for k in (stripe, stripe + 1))
        builder.slab(f"grass{stripe}", _grass((w, h, cut), low, high), GRASS[stripe % 2])
    if field["goals"]:  # the halfway line is one between goals
        builder.paint((-w, 0.0), (w, 0.0))
    for zone in footage.scenario.zones.values():
        if zone.drawn:
            outline = floor_outline(zone, footage.scenario.field)
            for start, end in zip(outline, [*outline[1:], *outline[:1]], strict=True):
                builder.paint(start, end, rgb(zone.colour) if zone.colour else LINE)
    for start, end in gate_lines(footage):
        builder.paint(start, end, GATE)
    edge = [(w - cut, h), (w, h - cut), (w, -h + cut), (w - cut, -h),
            (-w + cut, -h), (-w, -h + cut), (-w, h - cut), (-w + cut, h)]  # fmt: skip
    for start, end in zip(edge, [*edge[1:], edge[0]], strict=True):
        if start != end:
            builder.paint(start, end)
            _add_wall(builder, field, start, end)
    for goal in field["goals"]:
        _add_goal(builder, goal, h)


def _grass(field: Point3, low: float, high: float) -> list[Point]:
    """Return the corners of a stripe across a field (half width, half length, cut of its corners) between two y."""
    w, h, cut = field
    ys = sorted({low, high, *(y for y in (cut - h, h - cut) if low < y < high)})
    reach = [w - max(0.0, abs(y) - (h - cut)) for y in ys]
    return [(way * x, y) for way in (-1, 1) for x, y in zip(reach, ys, strict=True)]


def _add_wall(builder: _Builder, field: Mapping[str, Any], start: Point, end: Point) -> None:
    """Add a wall just outside an edge of the field; end walls leave the goals open."""
    height, h = (0.0, field["wall_height_m"]), field["length_m"] / 2
    ends = {"positive_y": 1, "negative_y": -1}
    goal = next((goal for goal in field["goals"] if start[1] == end[1] == ends[goal["end"]] * h), None)
    length = math.dist(start, end)
    # Edges run clockwise, so outside is on their left.
    out = (-(end[1] - start[1]) / length * WALL_M / 2, (end[0] - start[0]) / length * WALL_M / 2)
    pieces = [(start, end)]
    if goal is not None:
        way = 1 if end[0] > start[0] else -1
        post = way * goal["width_m"] / 2
        pieces = [(start, (-post, start[1])), ((post, start[1]), end)]
    for a, b in pieces:
        builder.bar((a[0] + out[0], a[1] + out[1]), (b[0] + out[0], b[1] + out[1]), WALL_M, height, WALL, 0.5)


def _add_goal(builder: _Builder, goal: Mapping[str, Any], h: float) -> None:
    sign, colour = (1 if goal["end"] == "positive_y" else -1), rgb(str(goal["colour"]))
    half, depth, top = goal["width_m"] / 2, goal["depth_m"], goal["wall_height_m"]
    near, far = sign * h, sign * (h + depth)
    builder.box((0, (near + far) / 2, -_FLOOR_M / 2), (half, depth / 2, _FLOOR_M / 2), mixed(colour, EDGE, 0.4))
    out = WALL_M / 2
    corners = [(-half - out, near), (-half - out, far + sign * out), (half + out, far + sign * out), (half + out, near)]
    for start, end in pairwise(corners):
        builder.bar(start, end, WALL_M, (0.0, top - 0.006), colour, 0.45)
        builder.bar(start, end, WALL_M, (top - 0.006, top), colour)


def _add_fixed(builder: _Builder, obstacle: Any) -> None:
    colour, height = rgb(obstacle.colour), obstacle.height_m
    if isinstance(obstacle, Cylinder):
        (x, y), geom = obstacle.centre_m, mujoco.mjtGeom.mjGEOM_CYLINDER
        _look(builder.body.add_geom(type=geom, pos=[x, y, height / 2], size=[obstacle.radius_m, height / 2, 0]), colour)
    elif isinstance(obstacle, Box):
        (x, y), (length, width) = obstacle.centre_m, obstacle.size_m
        builder.box((x, y, height / 2), (length / 2, width / 2, height / 2), colour, 1.0, obstacle.yaw_rad)
    else:  # it ends where it ends: a bar would reach beyond, as walls of the field do to meet in their corners
        (x1, y1), (x2, y2) = obstacle.from_m, obstacle.to_m
        half = (math.dist(obstacle.from_m, obstacle.to_m) / 2, obstacle.thickness_m / 2, height / 2)
        builder.box(((x1 + x2) / 2, (y1 + y2) / 2, height / 2), half, colour, 1.0, math.atan2(y2 - y1, x2 - x1))


def _add_entity(spec: Any, entity: Mapping[str, Any], lettering: Lettering, *, patch: bool) -> None:
    body = spec.worldbody.add_body(name=entity["name"], mocap=True)
    if entity["kind"] == "robot":
        _add_robot(spec, body, entity, lettering)
        if patch:
            half, across = entity["size_m"] / 2, entity["wheel_track_m"] / 2 + entity["wheel_width_m"]
            size = [half * 1.12, max(half, across) * 1.06, _PAINT_M / 2]
            geom = body.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, pos=[0, 0, -half + _PAINT_M], size=size)
            _look(geom, EDGE, 0.35)
    elif entity["kind"] == "ball":
        colour = rgb(str(entity["colour"]))
        texture = spec.add_texture(
            name=f"{entity['name']}/skin",
            type=mujoco.mjtTexture.mjTEXTURE_CUBE,
            builtin=mujoco.mjtBuiltin.mjBUILTIN_CHECKER,
            rgb1=_share(colour),
            rgb2=_share(mixed(colour, WHITE, 0.75)),
            width=32,
            height=192,
        )
        geom = body.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[entity["radius_m"], 0, 0])
        _look(geom, WHITE)
        geom.material = _material(spec, texture.name)
    else:
        height = entity["height_m"] / 2
        if entity["shape"] == "cylinder":
            geom = body.add_geom(type=mujoco.mjtGeom.mjGEOM_CYLINDER, size=[entity["radius_m"], height, 0])
        else:
            x_m, y_m = entity["size_m"]
            geom = body.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=[x_m / 2, y_m / 2, height])
        _look(geom, rgb(str(entity["colour"])))


def _add_robot(spec: Any, body: Any, entity: Mapping[str, Any], lettering: Lettering) -> None:
    half, colour, front = entity["size_m"] / 2, rgb(str(entity["colour"])), entity["front"]
    _look(body.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, size=[half, half, half]), colour)
    lid = body.add_geom(type=mujoco.mjtGeom.mjGEOM_BOX, pos=[0, 0, half], size=[half * 0.98, half * 0.98, 0.0006])
    _look(lid, WHITE)
    texture = spec.add_texture(
        name=f"{entity['name']}/lid", type=mujoco.mjtTexture.mjTEXTURE_2D, width=_LID_PX, height=_LID_PX, nchannel=3
    )
    texture.data = _lid(entity, colour, lettering).tobytes()
    lid.material = _material(spec, texture.name)
    # Two eyes on the front face.
    for side in (-1, 1):
        eye = body.add_geom(
            type=mujoco.mjtGeom.mjGEOM_BOX,
            pos=[front * half, side * half * 0.42, half * 0.3],
            size=[0.0012, half * 0.16, half * 0.16],
        )
        _look(eye, WHITE)
        wheel = body.add_geom(
            type=mujoco.mjtGeom.mjGEOM_CYLINDER,
            pos=[0, side * entity["wheel_track_m"] / 2, entity["wheel_radius_m"] - half],
            size=[entity["wheel_radius_m"], entity["wheel_width_m"] / 2, 0],
            quat=[math.sqrt(0.5), math.sqrt(0.5), 0, 0],
        )
        _look(wheel, WHEEL)


def _lid(entity: Mapping[str, Any], colour: Rgb, lettering: Lettering) -> Any:
    """Return the lid from above, the robot's front upwards: an arrow and the number."""
    image = Image.new("RGB", (_LID_PX, _LID_PX), mixed(colour, WHITE, 0.12))
    mask = lettering.mask(str(entity["number"]), round(_LID_PX * 0.66), bold=True)
    image.paste(text_on(colour), ((_LID_PX - mask.width) // 2, round(_LID_PX * 0.16)), mask)
    # The texture's rows run along the body's x: front upwards becomes front to +x.
    turned = image.transpose(Image.Transpose.ROTATE_270 if entity["front"] > 0 else Image.Transpose.ROTATE_90)
    return np.asarray(turned).copy()


def _material(spec: Any, texture: str) -> str:
    name = f"{texture}/material"
    material = spec.add_material(name=name)
    material.textures[mujoco.mjtTextureRole.mjTEXROLE_RGB] = texture
    return name


def _look(geom: Any, colour: Rgb, alpha: float = 1.0) -> None:
    geom.rgba = [*_share(colour), alpha]
    geom.contype = geom.conaffinity = 0


def _share(colour: Rgb) -> list[float]:
    return [part / 255 for part in colour]
