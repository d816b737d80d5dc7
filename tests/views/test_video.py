"""Videos: what an MP4 shows, how long it is, and that it is whole or not there."""

import errno
import json
import shutil
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import av
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.facts.timing import TICK_S
from rcj_challenges.records.errors import RecordError
from rcj_challenges.records.testing import GOAL_EVERY_TICKS, write_made_up_run
from rcj_challenges.views.video import footage as footage_module
from rcj_challenges.views.video import make
from rcj_challenges.views.video.camera import Camera
from rcj_challenges.views.video.errors import FilmInterruptedError, VideoError
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video.make import Look, size_from, studio, write_video
from rcj_challenges.views.video.timeline import (
    Clip,
    frame_count,
    highlights,
    moment_at,
    moments,
    seconds_from,
    stretch,
)

SIZE = (320, 180)
FPS = Fraction(25)
GOAL_S = GOAL_EVERY_TICKS * TICK_S


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return write_made_up_run(tmp_path_factory.mktemp("runs"), ticks=1000)


@pytest.fixture(scope="module")
def footage(folder):
    return Footage.open(folder)


def film(footage, clips, path, *, speed=1.0, fps=FPS, camera="field"):
    with studio(footage, Look(SIZE, camera, "top")) as made_in:
        return write_video(made_in, clips, path, size=SIZE, fps=fps, speed=speed)


def decoded(path):
    with av.open(str(path)) as container:
        stream = container.streams.video[0]
        pictures = [frame.to_ndarray(format="rgb24").astype(int) for frame in container.decode(stream)]
        return pictures, float(stream.duration * stream.time_base), stream.average_rate


def test_a_video_has_as_many_pictures_and_seconds_as_were_asked_for(footage, tmp_path):
    clips = stretch(footage, 2.0, 5.0, None)
    assert film(footage, clips, tmp_path / "v.mp4") == 75
    pictures, length_s, rate = decoded(tmp_path / "v.mp4")
    assert len(pictures) == 75
    assert pictures[0].shape == (180, 320, 3)
    assert length_s == pytest.approx(3.0)
    assert rate == FPS


@pytest.mark.parametrize(("speed", "pictures"), [(4.0, 19), (0.5, 150), (1.0, 75)])
def test_speed_makes_a_video_shorter_or_longer(footage, speed, pictures):
    clips = stretch(footage, 2.0, 5.0, None)
    assert frame_count(clips, 25.0, speed) == pictures
    shown = list(moments(footage, clips, 25.0, speed))
    assert len(shown) == pictures
    assert shown[1].t_s - shown[0].t_s == pytest.approx(speed / 25)
    assert all(2.0 <= moment.t_s < 5.0 for moment in shown)


def test_what_moves_is_seen_to_move(footage, tmp_path):
    film(footage, stretch(footage, 1.0, 3.0, None), tmp_path / "v.mp4")
    pictures, *_ = decoded(tmp_path / "v.mp4")
    assert np.abs(pictures[-1][20:] - pictures[0][20:]).max() > 80


def test_a_goal_changes_the_score_and_brings_its_caption_which_goes_again(footage, tmp_path):
    film(footage, stretch(footage, GOAL_S - 0.4, GOAL_S + 4.0, None), tmp_path / "v.mp4")
    pictures, *_ = decoded(tmp_path / "v.mp4")
    bottom, middle_of_board = slice(150, 178), (slice(2, 14), slice(140, 180))

    def yellow(picture):
        """How much of the place of captions is in the colour of the team that scored."""
        r, g, b = (picture[bottom, 40:280, channel] for channel in range(3))
        return ((r > 180) & (g > 140) & (b < 90)).mean()

    assert yellow(pictures[5]) < 0.1
    assert yellow(pictures[30]) > 0.3
    assert yellow(pictures[-1]) < 0.1
    assert np.abs(pictures[30][middle_of_board] - pictures[5][middle_of_board]).max() > 60


def test_highlights_are_the_six_seconds_before_each_goal_and_one_after(footage):
    found = highlights(footage, stretch(footage, None, None, None))
    assert [(clip.half, clip.title) for clip in found] == [
        (1, "Goal 1 of 4"),
        (1, "Goal 2 of 4"),
        (2, "Goal 3 of 4"),
        (2, "Goal 4 of 4"),
    ]
    assert found[0].from_s == pytest.approx(GOAL_S - 6)
    assert found[0].to_s == pytest.approx(GOAL_S + 1)


def test_goals_close_to_each_other_are_shown_in_one_highlight(footage):
    close = Footage(
        footage.scenario, footage.roster, footage.things, footage.halves,
        type(footage.story)(score_changes={1: [[300, {"blue": 1, "yellow": 0}], [400, {"blue": 1, "yellow": 1}]]}),
        footage.titles,
    )  # fmt: skip
    (only,) = highlights(close, stretch(close, None, None, None))
    assert only.title == "Score 1-2 of 2"
    assert (only.from_s, only.to_s) == (pytest.approx(300 * TICK_S - 6), pytest.approx(400 * TICK_S + 1))


def test_highlights_of_a_stretch_without_a_goal_are_refused(footage):
    with pytest.raises(VideoError, match="the score does not change"):
        highlights(footage, stretch(footage, 0.0, 3.0, None))


def test_seconds_count_over_the_halves_or_within_one(footage):
    length_s = footage.halves[0].length_s
    over = moment_at(footage, length_s + 4.0, None)
    within = moment_at(footage, 4.0, 2)
    assert over.half.info.half == within.half.info.half == 2
    assert over.t_s == pytest.approx(within.t_s) == 4.0
    assert stretch(footage, length_s - 1, length_s + 1, None) == [
        Clip(1, length_s - 1, length_s),
        Clip(2, 0.0, pytest.approx(1.0)),
    ]


@pytest.mark.parametrize(
    ("wish", "words"),
    [
        (lambda f: moment_at(f, 1e6, None), "beyond the end"),
        (lambda f: moment_at(f, 40.0, 2), "half 2 was recorded for 32 s"),
        (lambda f: moment_at(f, 1.0, 3), "no such half, but 1 and 2"),
        (lambda f: stretch(f, 5.0, 4.0, None), "must be before"),
        (lambda f: stretch(f, 5.0, 5.0, None), "must be before"),
        (lambda f: stretch(f, 0.0, 99.0, None), "--to 99 is beyond the end"),
        (lambda f: stretch(f, 70.0, None, None), "--from 70 is beyond the end"),
    ],
)
def test_times_that_were_not_played_are_refused(footage, wish, words):
    with pytest.raises(VideoError, match=words):
        wish(footage)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("1281x720", "even"), ("10x10", "160 to 4096"), ("99999x720", "160 to 4096"), ("big", "WIDTHxHEIGHT"),
        ("1280", "WIDTHxHEIGHT"), ("-640x480", "WIDTHxHEIGHT"), ("1280x720x3", "WIDTHxHEIGHT"), ("", "WIDTHxHEIGHT"),
    ],
)  # fmt: skip
def test_odd_and_absurd_sizes_are_refused(text, words):
    with pytest.raises(VideoError, match=words):
        size_from(text, even=True)


def test_sizes_are_written_in_pixels_or_by_name():
    assert size_from("1280x720", even=True) == size_from("720p", even=True) == (1280, 720)
    assert size_from("641x481", even=False) == (641, 481)


@pytest.mark.parametrize(("text", "seconds"), [("113.9", 113.9), ("1:53.9", 113.9), ("0", 0), ("10:00", 600), ("7", 7)])
def test_times_are_seconds_or_minutes_and_seconds(text, seconds):
    assert seconds_from(text) == pytest.approx(seconds)


@pytest.mark.parametrize("text", ["", "abc", "-1", "1:5", "1:99", "nan", "inf", "1e3", "1:2:3", "٣", "9" * 40])
def test_what_is_no_time_is_refused(text):
    with pytest.raises(VideoError, match="is no time"):
        seconds_from(text)


@given(st.text(max_size=12))
def test_any_text_is_a_time_or_refused(text):
    try:
        seconds = seconds_from(text)
    except VideoError:
        return
    assert 0 <= seconds < 1_000_000


@pytest.mark.parametrize(
    ("name", "words"),
    [("behind:Y9", "no robot 'Y9'"), ("behind:", "no robot"), ("tpo", "did you mean 'top'"), ("x" * 500, "unknown")],
)
def test_unknown_cameras_and_robots_are_told_with_what_there_is(footage, name, words):
    with pytest.raises(VideoError, match=words):
        Camera.named(name, footage.roster)


def test_cameras_that_need_three_dimensions_are_refused_from_above(footage):
    for camera in ("side", "behind:Y1"):
        with pytest.raises(VideoError, match="needs 3-D"), studio(footage, Look(SIZE, camera, "top")):
            pass


def test_without_a_graphics_library_it_is_drawn_from_above_and_said_so(footage, monkeypatch, tmp_path):
    monkeypatch.setattr(make.gl_probe, "why_not_solid", lambda: "no libEGL here")
    with studio(footage, Look(SIZE, "behind:Y1")) as made_in:
        told = " ".join(made_in.says)
        assert made_in.frame(moment_at(footage, 3.0, None)).size == SIZE
    assert "from above" in told
    assert "no libEGL here" in told
    assert "behind:Y1 needs 3-D" in told
    with pytest.raises(VideoError, match=r"no libEGL here.*--renderer top"), studio(footage, Look(SIZE, renderer="3d")):
        pass


def test_an_interrupted_video_is_kept_under_another_name_and_can_be_played(footage, tmp_path):
    path = tmp_path / "v.mp4"
    shown = stretch(footage, 0.0, 2.0, None)
    with studio(footage, Look(SIZE, renderer="top")) as made_in:

        def interrupt(done, total):
            if done == 20:
                raise KeyboardInterrupt

        with pytest.raises(FilmInterruptedError) as caught:
            write_video(made_in, shown, path, size=SIZE, fps=FPS, speed=1.0, progress=interrupt)
    assert [found.name for found in tmp_path.iterdir()] == ["v.part.mp4"]
    assert caught.value.frames == len(decoded(caught.value.kept)[0]) == 20


def test_a_video_that_cannot_take_the_place_of_one_that_is_shown_is_kept(footage, tmp_path, monkeypatch):
    """Windows lets nobody rename over a file that a player has open."""
    replace = Path.replace

    def refuses(path, target):
        if Path(target).name == "v.mp4":
            refused = PermissionError(errno.EACCES, "Access is denied", str(path))
            refused.winerror = 5
            raise refused
        return replace(path, target)

    monkeypatch.setattr(Path, "replace", refuses)
    monkeypatch.setattr("rcj_challenges.records.folder._WAIT_FOR_OTHERS_S", 0.01)
    path = tmp_path / "v.mp4"
    path.write_bytes(b"the old one")
    shown = stretch(footage, 0.0, 0.2, None)
    with (
        studio(footage, Look(SIZE, renderer="top")) as made_in,
        pytest.raises(
            VideoError, match=r"v\.mp4: cannot be written: Access is denied; close .* kept in .*v\.part\.mp4$"
        ),
    ):
        write_video(made_in, shown, path, size=SIZE, fps=FPS, speed=1.0)
    assert path.read_bytes() == b"the old one"
    assert sorted(found.name for found in tmp_path.iterdir()) == ["v.mp4", "v.part.mp4"]
    assert len(decoded(tmp_path / "v.part.mp4")[0]) == frame_count(shown, 25.0, 1.0)


def test_a_video_that_fails_leaves_nothing_and_spares_the_old_one(footage, tmp_path):
    path = tmp_path / "v.mp4"
    path.write_bytes(b"the old one")

    def fail(done, total):
        assert path.read_bytes() == b"the old one"
        if done == 3:
            raise RuntimeError("no more")

    with studio(footage, Look(SIZE, renderer="top")) as made_in:
        shown = stretch(footage, 0.0, 1.0, None)
        with pytest.raises(RuntimeError, match="no more"):
            write_video(made_in, shown, path, size=SIZE, fps=FPS, speed=1.0, progress=fail)
    assert [found.name for found in tmp_path.iterdir()] == ["v.mp4"]
    assert path.read_bytes() == b"the old one"


def test_a_place_that_cannot_be_written_is_told(footage, tmp_path):
    with pytest.raises(VideoError, match="cannot be written"):
        film(footage, stretch(footage, 0.0, 1.0, None), tmp_path / "nowhere" / "v.mp4")


def test_a_run_that_was_stopped_is_shown_as_far_as_it_went(tmp_path):
    folder = write_made_up_run(tmp_path, ticks=100, halves=1)
    result = json.loads((folder / "result.json").read_bytes())
    (folder / "result.json").write_text(json.dumps({**result, "complete": False, "stopped": "power cut"}), "utf-8")
    stopped = Footage.open(folder)
    assert stopped.warnings == (
        "This run was not played to its end (power cut): what was recorded is shown, 3.2 s of half 1.",
    )
    assert film(stopped, stretch(stopped, None, None, None), tmp_path / "v.mp4") == 80


def test_a_damaged_log_costs_the_captions_and_not_the_video(tmp_path, monkeypatch):
    folder = write_made_up_run(tmp_path, ticks=500, halves=1)
    log = folder / "referee.jsonl"
    log.write_bytes(b"\x00\xff{]\n" + log.read_bytes())
    assert "1 line of the referee's log is damaged and left out" in " ".join(Footage.open(folder).warnings)
    monkeypatch.setattr(footage_module, "tell", lambda *_: {}["no such seat"])
    footage = Footage.open(folder)
    assert "the referee's log is damaged" in " ".join(footage.warnings)
    with studio(footage, Look(SIZE, renderer="top")) as made_in:
        made_in.frame(moment_at(footage, 14.0, None))


def test_a_damaged_result_costs_nothing_that_the_trajectory_knows(tmp_path):
    folder = write_made_up_run(tmp_path, ticks=500, names=("Hanse", "Alster"))
    whole = Footage.open(folder)
    (folder / "result.json").write_text("{", encoding="utf-8")
    footage = Footage.open(folder)
    (warning,) = footage.warnings
    assert "result.json" in warning
    assert "cannot be read" in warning
    assert dict(footage.titles) == {"blue": "Hanse", "yellow": "Alster"}
    assert footage.story.events == whole.story.events != []
    assert footage.story.score_changes == whole.story.score_changes


def test_a_trajectory_that_lost_its_end_is_shown_as_far_as_it_goes(folder, tmp_path):
    cut = Path(shutil.copytree(folder, tmp_path / "run"))
    path = cut / "trajectory.npz"
    path.write_bytes(path.read_bytes()[: path.stat().st_size * 7 // 10])
    footage = Footage.open(cut)
    first, second = footage.halves
    assert first.ticks == 1000
    assert 0 < second.ticks < 1000
    assert f"32.0 s of half 1, {second.length_s:.1f} s of half 2" in footage.warnings[0]
    assert second.poses(second.length_s)[6, :2] == pytest.approx(first.poses(second.length_s)[6, :2])
    (cut / "result.json").write_text("{", encoding="utf-8")
    assert dict(Footage.open(cut).titles) == {"blue": "Hanse", "yellow": "Alster"}


@pytest.mark.parametrize("file", ["scenario.json", "trajectory.npz"])
def test_without_scenario_or_trajectory_there_is_nothing_to_show(tmp_path, file):
    folder = write_made_up_run(tmp_path, ticks=100)
    (folder / file).write_bytes((folder / file).read_bytes()[:500])
    with pytest.raises(RecordError, match=r"damaged"):
        Footage.open(folder)


def test_looking_for_a_graphics_library_and_drawing_from_above_load_no_physics():
    code = (
        "import sys; import rcj_challenges.cli.video; from rcj_challenges.views.video import make; "
        "sys.exit('mujoco' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], cwd=Path(__file__).parents[2], check=False).returncode == 0
