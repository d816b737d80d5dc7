"""Pictures of cameras, compared with MuJoCo's own rays."""

import hashlib
import math
import os
import random
import subprocess
import sys
import time
from dataclasses import replace

import mujoco
import numpy as np
import pytest
from numpy._core._multiarray_umath import __cpu_dispatch__, __cpu_features__

from rcj_challenges.devices.base import Eye
from rcj_challenges.world import contact
from rcj_challenges.world.camera_renderer import BEYOND, FLOOR, LINE, WALL, CameraRenderer
from tests.world.physics_stage import Stage

LOOK = Eye(bearing_rad=0.0, ahead_m=0.03, height_m=0.06, width=96, height=72, fov_rad=math.pi / 3, down=0.62)
OBSTACLES = {
    "crate": {"shape": "box", "centre_m": [0.2, 0.3], "size_m": [0.1, 0.06], "yaw_rad": 0.4, "height_m": 0.04},
    "pole": {"shape": "cylinder", "centre_m": [-0.3, 0.2], "radius_m": 0.03, "height_m": 0.05},
    "tower": {"shape": "cylinder", "centre_m": [-0.1, -0.5], "radius_m": 0.02, "height_m": 0.2},
    "screen": {"shape": "wall", "from_m": [-0.4, -0.2], "to_m": [-0.1, -0.3], "height_m": 0.15},
    "cart": {"shape": "box", "centre_m": [0.4, -0.4], "size_m": [0.08, 0.08], "movable": True, "colour": "violet"},
}
SEEN = np.array([group in {0, contact.GROUP_FIXTURES, contact.GROUP_CHASSIS, contact.GROUP_BALLS} for group in range(6)],
                np.uint8)  # fmt: skip


ROUND = {"chassis": {"drive": "omni", "shape": "flat_front", "jaws_m": (0.01, 0.05)}}
GOALS = {"blue_goal": {"colour": "purple"}, "yellow_goal": {"colour": "brown"}}
FREE_M = 0.14


@pytest.fixture(scope="module")
def stage() -> Stage:
    return Stage(
        obstacles=OBSTACLES, field={"goals": GOALS}, balls={"second": {"colour": "violet", "radius_m": 0.035}},
        kits={"round": ROUND}, robots={"B2": {"kit": "round"}, "Y2": {"kit": "round"}},
    )  # fmt: skip


def scatter(stage: Stage, rng: random.Random) -> None:
    """Put robots, balls and the cart where none is in another thing."""
    taken = [(0.2, 0.3), (-0.3, 0.2), (-0.1, -0.5), (-0.4, -0.2), (-0.25, -0.25), (-0.1, -0.3)]
    for name in stage.roster.entities:
        while True:
            x, y = rng.uniform(-0.58, 0.58), rng.uniform(-0.68, 0.68)
            if all(math.dist((x, y), other) > FREE_M for other in taken) and abs(x) + abs(y) < 1.2:
                break
        taken.append((x, y))
        stage.put(name, x, y, rng.uniform(-math.pi, math.pi))
    mujoco.mj_forward(stage.world.model, stage.world.data)


def geoms_by_ray(stage: Stage, robot: str, eye: Eye) -> np.ndarray:
    """Return which geom each pixel shows, by a ray through its middle: [rows, columns]; -1 for none."""
    model, data = stage.world.model, stage.world.data
    body = model.body(robot).id
    yaw = math.atan2(data.xmat[body, 3], data.xmat[body, 0]) + eye.bearing_rad
    origin = np.array([data.xpos[body, 0] + eye.ahead_m * math.cos(yaw), data.xpos[body, 1] + eye.ahead_m * math.sin(yaw),
                       eye.height_m])  # fmt: skip
    columns, rows = np.arange(eye.width), np.arange(eye.height)
    if eye.fov_rad < math.pi:
        edge = math.tan(eye.fov_rad / 2)
        pitch, aside, ahead = 2 * edge / eye.width, edge * (1 - 2 * (columns + 0.5) / eye.width), np.ones(eye.width)
    else:
        pitch = eye.fov_rad / eye.width
        angles = eye.fov_rad * (0.5 - (columns + 0.5) / eye.width)
        ahead, aside = np.cos(angles), np.sin(angles)
    up = ((1 - eye.down) * eye.height - (rows + 0.5)) * pitch
    x = np.broadcast_to(math.cos(yaw) * ahead - math.sin(yaw) * aside, (eye.height, eye.width))
    y = np.broadcast_to(math.sin(yaw) * ahead + math.cos(yaw) * aside, (eye.height, eye.width))
    ways = np.stack([x, y, np.broadcast_to(up[:, None], x.shape)], axis=-1).reshape(-1, 3)
    ways = ways / np.linalg.norm(ways, axis=1, keepdims=True)
    geoms, distances = np.zeros(len(ways), np.int32), np.zeros(len(ways))
    mujoco.mj_multiRay(model, data, origin, ways.ravel(), SEEN, 1, body, geoms, distances, None, len(ways), 100.0)
    return geoms.reshape(eye.height, eye.width)


def colours_by_ray(stage: Stage, sight: CameraRenderer, robot: str, eye: Eye) -> np.ndarray:
    """Return the kind of what each pixel shows: 0 floor, 1 walls and goals, 2 nothing, else 3 + the palette's number."""
    model, scenario = stage.world.model, stage.scenario
    kinds = {-1: 2}
    for geom in range(model.ngeom):
        name = model.geom(geom).name
        if name.startswith("field/"):
            kinds[geom] = 0 if name == "field/floor" else 1
            continue
        thing = name.removeprefix("obstacle/").partition("/")[0]
        if thing in scenario.robots or thing in scenario.balls or thing in scenario.obstacles:
            section = next(s for s in (scenario.robots, scenario.balls, scenario.obstacles) if thing in s)
            kinds[geom] = 3 + sight.number_of(section[thing].colour)
    return np.vectorize(kinds.get)(geoms_by_ray(stage, robot, eye))


def colours_in(picture: bytes, sight: CameraRenderer, eye: Eye) -> np.ndarray:
    """Return the same of a picture."""
    numbers = np.frombuffer(picture, np.uint8).reshape(eye.height, eye.width)
    field = {BEYOND: 2, FLOOR: 0, LINE: 0, WALL: 1}
    painted = dict.fromkeys((sight.number_of("purple"), sight.number_of("brown")), 1)
    kinds = np.array([{**field, **painted}.get(number, 3 + number) for number in range(len(sight.palette))])
    floors = [n for n, colour in enumerate(sight.palette) if colour in {(89, 0, 89), (115, 29, 29)}]
    kinds[floors] = 0
    return kinds[numbers]


LENSES = {
    "usual": LOOK,
    "sideways": replace(LOOK, bearing_rad=1.2, width=64, height=48),
    "high": replace(LOOK, height_m=0.11, ahead_m=0.0),
    "low": replace(LOOK, height_m=0.02, down=0.4),
    "panorama": replace(LOOK, fov_rad=math.tau, width=160, height=40, ahead_m=0.0),
}


@pytest.mark.parametrize("lens", LENSES)
def test_a_picture_shows_what_rays_through_its_pixels_meet(stage: Stage, lens: str) -> None:
    eye, rng = LENSES[lens], random.Random(lens)  # noqa: S311
    sight = CameraRenderer(stage.scenario, stage.roster, stage.world)
    robots = list(stage.scenario.robots)
    for _ in range(6):
        scatter(stage, rng)
        pictures = sight.take([(stage.index(name), eye) for name in robots])
        for name, picture in zip(robots, pictures, strict=True):
            shown, met = colours_in(picture, sight, eye), colours_by_ray(stage, sight, name, eye)
            np.testing.assert_array_equal(shown, met)


def digest() -> str:
    """Return the digest of some pictures."""
    stage, rng = Stage(obstacles=OBSTACLES, field={"goals": GOALS}), random.Random(3)  # noqa: S311
    sight, seen = CameraRenderer(stage.scenario, stage.roster, stage.world), hashlib.sha256()
    for _ in range(3):
        scatter(stage, rng)
        for eye in LENSES.values():
            for picture in sight.take([(stage.index(name), eye) for name in stage.scenario.robots]):
                seen.update(picture)
    return seen.hexdigest()


def test_pictures_are_the_same_without_the_fast_instructions_of_this_processor() -> None:
    fast = " ".join(feature for feature in __cpu_dispatch__ if __cpu_features__.get(feature))
    if not fast:
        pytest.skip("numpy has no fast instructions to switch off here")
    simple = {**os.environ, "NPY_DISABLE_CPU_FEATURES": fast}
    program = "from tests.world.test_camera_renderer import digest; print(digest())"
    ran = subprocess.run([sys.executable, "-c", program], env=simple, capture_output=True, text=True, check=True)
    assert ran.stdout.strip() == digest()


def test_spots_and_circles_around_them_that_are_drawn_are_seen_on_the_floor() -> None:
    stage = Stage(
        spots={"seen": {"x_m": 0.3, "y_m": 0.3, "drawn": True}, "unseen": {"x_m": 0.3, "y_m": -0.2}},
        zones={"ring": {"shape": "circle", "anchor": "unseen", "radius_m": 0.1, "drawn": True}},
    )
    bright = CameraRenderer(stage.scenario, stage.roster, stage.world).brightness
    assert [bright(*at) > 0.9 for at in ((0.3, 0.3), (0.3, -0.2), (0.4, -0.2))] == [True, False, True]


def test_lines_of_the_largest_field_are_drawn_at_once() -> None:
    ring = {"shape": "circle", "centre_m": [0, 0], "radius_m": 0.5, "drawn": True}
    stage = Stage(field={"width_m": 10.0, "length_m": 10.0}, zones={"ring": ring})
    began = time.process_time()
    CameraRenderer(stage.scenario, stage.roster, stage.world)
    assert time.process_time() - began < 5  # looking at all cells for each line takes 20 s
