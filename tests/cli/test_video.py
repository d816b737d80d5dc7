"""The commands video and snapshot; what draws is replaced, see tests/views/test_video_rendering.py."""

from contextlib import contextmanager

import av
import pytest
from PIL import Image

from rcj_challenges.cli.commands import load_app
from rcj_challenges.core.errors import RcjError
from rcj_challenges.views.video import make, requirements
from tests.made_up_runs import write_made_up_run


def run(*arguments):
    return load_app()(list(map(str, arguments)), standalone_mode=False)


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    runs = tmp_path_factory.mktemp("runs")
    write_made_up_run(runs, ticks=500, halves=1)
    return runs


@pytest.fixture(autouse=True)
def drawn(monkeypatch):
    """Draws plain pictures; returns the moments that were drawn."""
    moments = []

    @contextmanager
    def plain(footage, size, camera, *, fine=False):
        yield lambda moment: moments.append(moment) or Image.new("RGB", size)

    monkeypatch.setattr(make, "opened_renderer", plain)
    return moments


def test_video_is_written_where_asked_and_its_place_is_printed(runs, tmp_path, capsys, drawn):
    out = tmp_path / "v.mp4"
    assert (
        run("video", "--runs", runs, "--from", "12", "--to", "0:13", "--size", "320x180", "--fps", "10", "-o", out) == 0
    )
    assert capsys.readouterr().out.strip() == str(out)
    with av.open(str(out)) as container:
        assert container.streams.video[0].frames == 10
    assert [moment.t_s for moment in drawn] == pytest.approx([12 + k / 10 for k in range(10)])


def test_highlights_and_snapshots_go_into_the_record_by_default(runs, capsys):
    (folder,) = runs.iterdir()
    options = ("--runs", runs, "--size", "320x180")
    assert run("video", folder.name, "--highlights", "--fps", "5", "--quiet", *options) == 0
    assert run("snapshot", folder.name, "--at", "12.9", *options) == 0
    printed = capsys.readouterr().out.splitlines()
    assert printed == [str(folder / "highlights.mp4"), str(folder / "snapshot-half1-12.900s.png")]
    with av.open(printed[0]) as container:
        assert container.streams.video[0].frames == 35
    with Image.open(printed[1]) as picture:
        assert (picture.format, picture.size) == ("PNG", (320, 180))


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (("snapshot", "--at", "999"), "time-not-played"),
        (("snapshot", "--at", "5", "--half", "2"), "no-such-half"),
        (("snapshot", "--at", "soon"), "bad-time"),
        (("snapshot", "--at", "5", "--out", "picture.jpg"), "bad-out"),
        (("video", "--from", "9", "--to", "3"), "empty-clip"),
        (("video", "--size", "321x180"), "bad-size"),
        (("video", "--size", "10x10"), "bad-size"),
        (("video", "--size", "99999x720"), "bad-size"),
        (("video", "--size", "big"), "bad-size"),
        (("video", "--size", "1280x720x3"), "bad-size"),
        (("video", "--fps", "0"), "bad-fps"),
        (("video", "--speed", "0"), "bad-speed"),
        (("video", "--out", "."), "bad-out"),
        (("video", "--out", "no/such/folder/v.mp4"), "bad-out"),
    ],
)
def test_wrong_input_exits_with_2_and_writes_nothing(runs, arguments, code, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(RcjError) as error:
        run(*arguments, "--runs", runs)
    assert error.value.code == code
    assert error.value.exit_code == 2
    assert list(tmp_path.iterdir()) == []


def test_unknown_run_exits_with_2(runs):
    with pytest.raises(RcjError) as error:
        run("video", "nobody", "--runs", runs)
    assert error.value.exit_code == 2


def test_sizes_have_names_and_snapshots_may_be_odd():
    assert make.parse_size("1280x720", even=True) == make.parse_size("720p", even=True) == (1280, 720)
    assert make.parse_size("641x481", even=False) == (641, 481)


@pytest.mark.parametrize("arguments", [("video",), ("snapshot", "--at", "3")])
def test_missing_extra_exits_with_2(runs, arguments, monkeypatch):
    monkeypatch.setattr(requirements, "find_spec", lambda _: None)
    with pytest.raises(RcjError) as error:
        run(*arguments, "--runs", runs)
    assert error.value.code == "missing-extra"
    assert error.value.exit_code == 2
