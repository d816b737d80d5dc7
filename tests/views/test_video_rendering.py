"""Pictures drawn by MuJoCo: things are seen where the camera must see them."""

import os
import subprocess
import sys
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from rcj_challenges.core.errors import RcjError
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.video.camera import Camera
from rcj_challenges.views.video.clips import moment_at
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video.overlay import bar_height_px
from rcj_challenges.views.video.requirements import offscreen_opengl
from tests.made_up_runs import small_scenario, write_made_up_run
from tests.views.video_scenes import pixel_at

ROOT = Path(__file__).parents[2]

# In a process of its own: MuJoCo reads the backend when it is imported.
DRAW = """
import sys
from pathlib import Path
from rcj_challenges.views.video.clips import moment_at
from rcj_challenges.core.errors import RcjError
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video import make
from tests.views.video_scenes import JUDGED_GATE, playing
runs, out = map(Path, sys.argv[1:])
footage = playing(Footage.open(next(runs.iterdir())), JUDGED_GATE % "{from_m: [0.12, 0.05], to_m: [0.12, -0.05], anchor: Y1}")
if "mujoco" in sys.modules:
    sys.exit("MuJoCo reads the backend when it is imported: that must be chosen before")
try:
    with make.opened_renderer(footage, (480, 360), "top") as draw:
        make.write_snapshot(draw, moment_at(footage, 0.5, None), out / "here.png")
        footage.halves[0].poses[:] = float("nan")
        make.write_snapshot(draw, moment_at(footage, 0.5, None), out / "away.png")
except RcjError:
    sys.exit(77)
"""
BALL = 6


@pytest.fixture(scope="module")
def pictures(tmp_path_factory):
    runs, out = tmp_path_factory.mktemp("runs"), tmp_path_factory.mktemp("pictures")
    footage = Footage.open(write_made_up_run(runs, ticks=40, halves=1))
    done = subprocess.run(
        [sys.executable, "-c", DRAW, runs, out], capture_output=True, text=True, cwd=ROOT, check=False,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    if done.returncode == 77:
        pytest.skip("no OpenGL here")
    assert done.returncode == 0, done.stderr
    return footage, {path.stem: np.asarray(Image.open(path).convert("RGB")).astype(int) for path in out.iterdir()}


def expected_px(footage, point_m, picture):
    """Return where a point is in a picture from above with a scoreboard."""
    height, width, _ = picture.shape
    bar = bar_height_px((width, height))
    view = Camera("top").view(footage, moment_at(footage, 0.5, None), width / (height - bar))
    x, y = pixel_at(point_m, view, (width, height - bar))
    return np.array([x, y + bar])


def middle_px(is_it):
    rows, columns = np.nonzero(is_it)
    assert len(rows) > 10
    return np.array([columns.mean(), rows.mean()])


def is_pink(picture):
    red, green, blue = np.moveaxis(picture, 2, 0)
    return (red > green + 60) & (blue > green + 20)


def is_orange(picture):
    red, green, blue = np.moveaxis(picture, 2, 0)
    return (red > green + 70) & (green > blue - 10)


def test_ball_and_gate_of_a_robot_are_drawn_where_the_camera_sees_them(pictures):
    footage, drawn = pictures
    poses = footage.halves[0].poses_at(0.5)
    x_m, y_m, yaw_rad, _ = poses[footage.roster.index["Y1"]]
    gate_m = (x_m + 0.13 * np.cos(yaw_rad), y_m + 0.13 * np.sin(yaw_rad), 0.0)
    assert np.hypot(*(middle_px(is_pink(drawn["here"])) - expected_px(footage, gate_m, drawn["here"]))) < 6
    assert (
        np.hypot(*(middle_px(is_orange(drawn["here"])) - expected_px(footage, poses[BALL][[0, 1, 3]], drawn["here"])))
        < 3
    )


def test_nothing_off_the_field_is_drawn(pictures):
    _, drawn = pictures
    assert not is_pink(drawn["away"]).any()
    assert not is_orange(drawn["away"]).any()


@pytest.mark.parametrize("kind", ["field", "top", "side"])
@pytest.mark.parametrize("aspect", [16 / 9, 9 / 16])
def test_still_camera_sees_the_whole_field_with_the_blue_goal_left_or_up(tmp_path_factory, kind, aspect):
    footage = Footage.open(write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=1, halves=1))
    size = (1000, round(1000 / aspect))
    view = Camera(kind).view(footage, moment_at(footage, 0, None), aspect)
    corners = [pixel_at((x, y, 0), view, size) for x, y in product((-0.65, 0.65), (-0.75, 0.75))]
    corners += [pixel_at((x, y, 0), view, size) for x, y in product((-0.2, 0.2), (-0.849, 0.849))]
    assert all(0 < x < size[0] and 0 < y < size[1] for x, y in corners)
    assert max(np.ptp(corners, axis=0) / size) > 0.8
    blue, yellow = (pixel_at((0, y, 0), view, size) for y in (0.75, -0.75))
    assert (blue[0] < yellow[0] - 100) if aspect > 1 else (blue[1] < yellow[1] - 100)


@pytest.mark.parametrize("name", ["behind:Y9", "behind:", "tpo", "x" * 500])
def test_unknown_cameras_and_robots_are_refused(name):
    with pytest.raises(RcjError) as error:
        Camera.parse(name, Roster.of(small_scenario()))
    assert error.value.code == "unknown-camera"


def test_missing_opengl_is_an_error_with_what_to_install(monkeypatch):
    monkeypatch.setenv("MUJOCO_GL", "")  # afterwards it is as it was
    with pytest.raises(RcjError) as error, offscreen_opengl():
        raise ImportError("no libEGL")
    assert error.value.code == "no-opengl"
    assert "no libEGL" in str(error.value)
