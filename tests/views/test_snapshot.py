"""Snapshots: that what they show stands where the trajectory says, and that names can be read."""

import subprocess
import sys
from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from PIL import Image, features

from rcj_challenges.facts.play import Placement, Verdict
from rcj_challenges.facts.timing import TICK_S
from rcj_challenges.records.testing import (
    half_info,
    made_up_snapshot,
    small_header,
    small_scenario,
    write_made_up_run,
)
from rcj_challenges.records.trajectory import Trajectory
from rcj_challenges.records.writer import RecordWriter
from rcj_challenges.views.video import gl_probe
from rcj_challenges.views.video.errors import VideoError
from rcj_challenges.views.video.fontfile import characters_of
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video.lettering import Lettering
from rcj_challenges.views.video.make import Look, studio, write_snapshot
from rcj_challenges.views.video.timeline import Moment, moment_at

BALL = 6
ORANGE = np.array([232, 89, 12])


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=900)


@pytest.fixture(scope="module")
def footage(folder):
    return Footage.open(folder)


def place_of(picture, colour, near, reach=14):
    """Return the middle of the pixels of a colour around a place, in continuous pixel coordinates."""
    left, top = (max(0, int(value) - reach) for value in near)
    part = np.asarray(picture)[top : top + 2 * reach, left : left + 2 * reach].astype(int)
    ys, xs = np.nonzero(np.abs(part - colour).sum(axis=2) < 110)
    return left + xs.mean() + 0.5, top + ys.mean() + 0.5


@pytest.mark.parametrize("camera", ["top", "follow-ball"])
@pytest.mark.parametrize("size", [(1280, 720), (720, 1280)])
@pytest.mark.parametrize("tick", [3, 250, 371, 833])
def test_the_ball_is_drawn_where_the_trajectory_has_it(folder, footage, camera, size, tick):
    x_m, y_m, _ = Trajectory.open(folder).halves[0].substeps[tick - 1, -1, BALL]
    moment = moment_at(footage, tick * TICK_S, None)
    with studio(footage, Look(size, camera, "top")) as made_in:
        at = made_in._stage.projection(moment).px(x_m, y_m)
        seen = place_of(made_in._stage.picture(moment), ORANGE, at)
    assert np.hypot(seen[0] - at[0], seen[1] - at[1]) < 1


def test_what_is_placed_as_a_half_starts_stands_there_from_the_first_picture_on(tmp_path):
    scenario = small_scenario(halves=1, half_s=1)
    header = small_header(scenario)
    writer = RecordWriter(tmp_path, header)
    writer.begin_half(half_info(scenario, 1, 10, header))
    placed = (Placement(BALL, 0.2, -0.1, 0.0), Placement(0, 0.0, 0.0, 0.0, parked=True))
    for tick in range(11):
        writer.tick(made_up_snapshot(tick, 6), Verdict(placements=() if tick else placed), b"")
    writer.end_half(Verdict())
    (half,) = Footage.open(writer.finish({"wall_s": 1.0})).halves
    start = half.poses(0.0)
    assert start[BALL, :2] == pytest.approx((0.2, -0.1))
    assert np.isnan(start[0]).all()
    assert start[1, :2] == pytest.approx(made_up_snapshot(0, 6).substeps[-1][1][:2])
    assert np.isnan(half.poses(0.004)[0]).all()


def test_the_field_lies_as_in_the_replay_page(footage):
    """Blue's goal (+y) is on the left of a wide picture, at the top of a tall one; +x is up or right."""
    moment = moment_at(footage, 1.0, None)
    with studio(footage, Look((1280, 720), "top", "top")) as made_in:
        view = made_in._stage.projection(moment)
        assert view.px(0, 0.75)[0] < view.px(0, -0.75)[0]
        assert view.px(0.65, 0)[1] < view.px(-0.65, 0)[1]
        blue = np.asarray(made_in._stage.picture(moment))[int(view.px(0, 0.8)[1]), int(view.px(0, 0.8)[0])]
        assert blue[2] > 100 > blue[0]
    with studio(footage, Look((720, 1280), "top", "top")) as made_in:
        view = made_in._stage.projection(moment)
        assert view.px(0, 0.75)[1] < view.px(0, -0.75)[1]
        assert view.px(0.65, 0)[0] > view.px(-0.65, 0)[0]


def test_a_robot_shows_its_front_where_it_looks(folder, footage):
    """The white arrow lies from the middle of the robot in the direction of its yaw."""
    tick, robot = 500, 4
    x_m, y_m, yaw = Trajectory.open(folder).halves[0].substeps[tick - 1, -1, robot].tolist()
    moment = moment_at(footage, tick * TICK_S, None)
    with studio(footage, Look((1920, 1080), "top", "top")) as made_in:
        view = made_in._stage.projection(moment)
        picture = made_in._stage.picture(moment)
    ahead, behind = (
        picture.getpixel(tuple(map(int, view.px(x_m + way * 0.029 * np.cos(yaw), y_m + way * 0.029 * np.sin(yaw)))))
        for way in (1, -1)
    )
    assert min(ahead) > 200
    assert min(behind) < 120


def test_between_ticks_things_are_between_their_places_and_jumps_are_not_smoothed(folder, footage):
    half, track = footage.halves[0], Trajectory.open(folder).halves[0]
    before, after = track.substeps[249, -1], track.substeps[250, 0]
    middle = half.poses(250 * TICK_S + 0.004)
    assert middle[:, :2] == pytest.approx((before[:, :2] + after[:, :2]) / 2, abs=1e-6)
    assert half.poses(250 * TICK_S)[:, :3] == pytest.approx(before)
    # After tick 400 the ball is put into the middle: until the next sample it is where it was.
    assert half.poses(400 * TICK_S + 0.007)[BALL, :2] == pytest.approx(track.substeps[399, -1, BALL, :2])
    assert half.poses(400 * TICK_S + 0.008)[BALL, :2] == pytest.approx(track.substeps[400, 0, BALL, :2])


def test_what_is_parked_or_no_number_is_not_drawn(footage):
    half = footage.halves[0]
    samples = half.samples.copy()
    samples[:, 0, 0], samples[:, 1, 1], samples[:, BALL, 0] = 1000.0, np.nan, np.inf
    away = Moment(type(half)(half.info, half.ticks, samples, half.heights, half.jumps), 3.0)
    assert np.isnan(away.half.poses(3.0)[[0, 1, BALL]]).all()
    for camera in ("top", "follow-ball"):
        with studio(footage, Look((640, 360), camera, "top")) as made_in:
            picture = np.asarray(made_in._stage.picture(away)).astype(int)
        assert (np.abs(picture - ORANGE).sum(axis=2) < 30).sum() == 0


def test_a_snapshot_is_a_png_of_the_size_asked_for(footage, tmp_path):
    with studio(footage, Look((641, 481), renderer="top")) as made_in:
        write_snapshot(made_in, moment_at(footage, 12.9, None), tmp_path / "s.png")
        with pytest.raises(VideoError, match="cannot be written"):
            write_snapshot(made_in, moment_at(footage, 12.9, None), tmp_path / "nowhere" / "s.png")
    with Image.open(tmp_path / "s.png") as picture:
        assert (picture.format, picture.size) == ("PNG", (641, 481))
    assert [found.name for found in tmp_path.iterdir()] == ["s.png"]


@pytest.mark.parametrize(
    "name", ["<script>", "x" * 10_000, "كرة القدم", "机器人足球", "\u202eevil", "A\nB", "\U0001f916", ""]
)
def test_any_name_can_stand_on_the_board(tmp_path, name):
    footage = Footage.open(write_made_up_run(tmp_path, ticks=30, halves=1, names=(name, "Alster")))
    with studio(footage, Look((320, 180), renderer="top")) as made_in:
        assert made_in.frame(moment_at(footage, 0.5, None)).size == (320, 180)


def test_without_fonts_letters_lose_their_marks_and_what_remains_are_boxes():
    bare = Lettering([])
    assert bare.mask("Zürich \N{EN DASH} Łódź", 30).tobytes() == bare.mask("Zurich - Lodz", 30).tobytes()
    assert not bare.boxes
    bare.mask("机器人", 30)
    assert "".join(bare.boxes) == "机器人"


@pytest.mark.parametrize("text", ["足球", "Żółw", "Ёж", "فريق"])
def test_scripts_are_written_with_the_fonts_of_the_system(text):
    lettering = Lettering()
    mask = lettering.mask(text, 40)
    if lettering.boxes:
        pytest.skip(f"no font of this system has {text}")
    assert mask.getbbox() is not None
    assert mask.tobytes() != lettering.mask("?" * len(text), 40).tobytes()


@pytest.mark.skipif(not features.check("raqm"), reason="this Pillow cannot shape")
def test_arabic_letters_are_joined():
    lettering = Lettering()
    joined, apart = (
        lettering.mask(text, 40).width for text in ("\u0633\u0644\u0627\u0645", "\u0633 \u0644 \u0627 \u0645")
    )
    if lettering.boxes:
        pytest.skip("no font of this system has Arabic")
    assert joined < 0.8 * apart


@settings(max_examples=40, deadline=None)
@given(st.text(max_size=300), st.integers(1, 300))
@example("\N{PARAGRAPH SEPARATOR}", 1)
@example("two\N{LINE SEPARATOR}lines", 100)
def test_text_is_cut_to_the_room_there_is(text, widest):
    bare = Lettering([])
    fitted = bare.fitted(text, 20, widest)
    assert fitted == "" or bare.width(fitted, 20) <= max(widest, 1)


@settings(max_examples=60)
@given(st.binary(max_size=400), st.booleans())
def test_anything_that_is_no_font_has_no_characters(data, headed):
    header = b"\x00\x01\x00\x00\x00\x02\x00\x00\x00\x00\x00\x00"
    assert isinstance(characters_of(BytesIO(header + data if headed else data)), frozenset)


def test_a_drawing_that_fails_is_a_reason_and_no_crash(monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "mujoco", None)
    monkeypatch.setenv("MUJOCO_GL", "egl")
    monkeypatch.setattr(gl_probe, "_DRAW_ONE", "raise ImportError('no such library: libEGL')")
    reason = gl_probe.why_not_solid()
    assert "no such library: libEGL" in reason
    assert "EGL" in reason
    (tmp_path / "of_the_team.py").touch()  # files of a team may lie in the current folder, and are none of ours
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(gl_probe, "_DRAW_ONE", "import of_the_team")
    assert "No module named 'of_the_team'" in gl_probe.why_not_solid()
    monkeypatch.setattr(gl_probe, "_DRAW_ONE", "import os; os.abort()")
    assert "ended with" in gl_probe.why_not_solid()


def test_in_three_dimensions_the_ball_stands_where_the_camera_sees_it(folder, tmp_path):
    """In a process of its own: the graphics backend is chosen before MuJoCo is loaded."""
    out = tmp_path / "s.png"
    code = f"""
import sys
from pathlib import Path
from rcj_challenges.views.video import gl_probe
reason = gl_probe.why_not_solid()
if reason:
    print(reason); sys.exit(77)
gl_probe.why_not_solid = lambda: None  # asked once is enough
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video.make import Look, studio, write_snapshot
from rcj_challenges.views.video.timeline import moment_at
footage = Footage.open(Path({str(folder)!r}))
moment = moment_at(footage, 147 * 0.032, None)
with studio(footage, Look((960, 540), "follow-ball", "3d")) as made_in:
    made_in.frame(moment).save({str(out)!r})
    print(*made_in._stage._px(tuple(moment.half.poses(moment.t_s)[6][[0, 1, 3]])))
"""
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, cwd=Path(__file__).parents[2], check=False
    )
    if done.returncode == 77:
        pytest.skip(done.stdout)
    assert done.returncode == 0, done.stderr
    at = tuple(map(float, done.stdout.split()))
    with Image.open(out) as picture:
        part = np.asarray(picture.convert("RGB"))[int(at[1]) - 25 : int(at[1]) + 25, int(at[0]) - 25 : int(at[0]) + 25]
    red, green, blue = (part[:, :, channel].astype(int) for channel in range(3))
    ys, xs = np.nonzero((red > green + 8) & (red > 120) & (green > blue - 10))
    assert len(xs) > 50
    assert np.hypot((xs.min() + xs.max()) / 2 - 25, (ys.min() + ys.max()) / 2 - 25) < 3
