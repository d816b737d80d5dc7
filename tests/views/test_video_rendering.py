"""Pictures drawn by MuJoCo: things are seen where the camera must see them."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from rcj_challenges.records.testing import small_scenario, write_made_up_run
from rcj_challenges.scenario.roster import Roster
from rcj_challenges.views.video import opengl
from rcj_challenges.views.video.camera import Camera, pixel_at
from rcj_challenges.views.video.clips import moment_at
from rcj_challenges.views.video.errors import VideoError
from rcj_challenges.views.video.footage import Footage

ROOT = Path(__file__).parents[2]

# In a process of its own: MuJoCo reads the backend when it is imported.
DRAW = """
import sys
from pathlib import Path
from rcj_challenges.views.video.clips import moment_at
from rcj_challenges.views.video.errors import VideoError
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video import make
from rcj_challenges.views.video.opengl import choose_backend
from tests.views.video_scenes import JUDGED_GATE, playing
runs, out = map(Path, sys.argv[1:])
footage = Footage.open(next(runs.iterdir()))
gate = playing(footage, JUDGED_GATE % "{from_m: [0.12, 0.05], to_m: [0.12, -0.05], anchor: Y1}")
try:
    choose_backend()
except VideoError:
    sys.exit(77)
make.choose_backend = lambda: None  # once is enough
with make.opened_renderer(footage, (640, 480), "follow-ball", fine=True) as draw:
    make.write_snapshot(draw, moment_at(footage, 0.5, None), out / "ball.png")
with make.opened_renderer(gate, (640, 480), "top") as draw:
    make.write_snapshot(draw, moment_at(gate, 0.5, None), out / "gate.png")
    gate.halves[0].samples[:] = float("nan")
    make.write_snapshot(draw, moment_at(gate, 0.5, None), out / "away.png")
"""


@pytest.fixture(scope="module")
def pictures(tmp_path_factory):
    runs, out = tmp_path_factory.mktemp("runs"), tmp_path_factory.mktemp("pictures")
    footage = Footage.open(write_made_up_run(runs, ticks=40))
    done = subprocess.run(
        [sys.executable, "-c", DRAW, runs, out], capture_output=True, text=True, cwd=ROOT, check=False,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )  # fmt: skip
    if done.returncode == 77:
        pytest.skip("no OpenGL here")
    assert done.returncode == 0, done.stderr
    return footage, {path.stem: np.asarray(Image.open(path).convert("RGB")).astype(int) for path in out.iterdir()}


def expected_px(footage, camera, point_m, picture):
    """Return where a point is in a picture with a scoreboard."""
    bar = 41
    height, width, _ = picture.shape
    moment = moment_at(footage, 0.5, None)
    view = Camera.parse(camera, footage.roster).view(footage, moment, width / (height - bar))
    x, y = pixel_at(point_m, view, (width, height - bar))
    return x, y + bar


def is_pink(picture):
    red, green, blue = np.moveaxis(picture, 2, 0)
    return (red > green + 60) & (blue > green + 20)


def test_ball_is_drawn_where_the_camera_sees_it(pictures):
    footage, drawn = pictures
    picture = drawn["ball"]
    ball = moment_at(footage, 0.5, None).half.poses(0.5)[6]
    x, y = expected_px(footage, "follow-ball", ball[[0, 1, 3]], picture)
    part = picture[int(y) - 25 : int(y) + 25, int(x) - 25 : int(x) + 25]
    red, green, blue = np.moveaxis(part, 2, 0)
    rows, columns = np.nonzero((red > green + 8) & (red > 120) & (green > blue - 10))
    assert len(rows) > 50
    assert np.hypot(np.ptp(columns) / 2 + columns.min() - 25, np.ptp(rows) / 2 + rows.min() - 25) < 3


def test_gate_that_moves_is_drawn_before_its_robot(pictures):
    footage, drawn = pictures
    x_m, y_m, yaw_rad, _ = moment_at(footage, 0.5, None).half.poses(0.5)[footage.roster.index["Y1"]]
    middle_m = (x_m + 0.13 * np.cos(yaw_rad), y_m + 0.13 * np.sin(yaw_rad), 0.0)
    rows, columns = np.nonzero(is_pink(drawn["gate"]))
    assert len(rows) > 20
    assert (
        np.hypot(*(np.array([columns.mean(), rows.mean()]) - expected_px(footage, "top", middle_m, drawn["gate"]))) < 8
    )


def test_nothing_off_the_field_is_drawn(pictures):
    _, drawn = pictures
    assert not is_pink(drawn["away"]).any()


@pytest.mark.parametrize("kind", ["field", "top", "side"])
@pytest.mark.parametrize("aspect", [16 / 9, 9 / 16])
def test_still_camera_sees_the_whole_field_with_the_blue_goal_left_or_up(tmp_path_factory, kind, aspect):
    footage = Footage.open(write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=1, halves=1))
    size = (1000, round(1000 / aspect))
    view = Camera(kind).view(footage, moment_at(footage, 0, None), aspect)
    corners = [pixel_at((x, y, 0), view, size) for x in (-0.65, 0.65) for y in (-0.849, 0.849)]
    assert all(0 < x < size[0] and 0 < y < size[1] for x, y in corners)
    assert max(np.ptp(corners, axis=0) / size) > 0.8
    blue, yellow = (pixel_at((0, y, 0), view, size) for y in (0.75, -0.75))
    assert (blue[0] < yellow[0] - 100) if aspect > 1 else (blue[1] < yellow[1] - 100)


@pytest.mark.parametrize(
    ("name", "code"),
    [
        ("behind:Y9", "unknown-robot"),
        ("behind:", "unknown-robot"),
        ("tpo", "unknown-camera"),
        ("x" * 500, "unknown-camera"),
    ],
)
def test_unknown_cameras_and_robots_are_refused(name, code):
    with pytest.raises(VideoError) as error:
        Camera.parse(name, Roster.of(small_scenario()))
    assert error.value.diagnostics[0].code == code


def test_backend_that_fails_or_crashes_is_a_reason_and_the_next_is_tried(monkeypatch):
    monkeypatch.setenv("MUJOCO_GL", "")  # unlike delenv, it takes away afterwards what the choice sets
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setattr(opengl, "_LINUX_BACKENDS", ("one", "two", "three"))
    script = "import os\nif os.environ['MUJOCO_GL'] == 'one': raise ImportError('no libone')\n"
    script += "if os.environ['MUJOCO_GL'] == 'two': os.abort()\n"
    monkeypatch.setattr(opengl, "_DRAW_ONE", script)
    opengl.choose_backend()
    assert os.environ["MUJOCO_GL"] == "three"
    monkeypatch.setattr(opengl, "_LINUX_BACKENDS", ("one", "two"))
    monkeypatch.setenv("MUJOCO_GL", "")
    with pytest.raises(VideoError) as error:
        opengl.choose_backend()
    assert error.value.diagnostics[0].code == "no-opengl"
    assert "no libone" in json.dumps(error.value.diagnostics[0].to_json())


def test_probe_of_opengl_imports_no_file_of_the_current_folder(monkeypatch, tmp_path):
    (tmp_path / "of_the_team.py").touch()
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("MUJOCO_GL", "egl")
    monkeypatch.setattr(opengl, "_DRAW_ONE", "import of_the_team")
    with pytest.raises(VideoError):
        opengl.choose_backend()


def test_commands_load_no_mujoco_before_they_draw():
    code = "import sys; import rcj_challenges.cli.video; from rcj_challenges.views.video import make; sys.exit('mujoco' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=False).returncode == 0
