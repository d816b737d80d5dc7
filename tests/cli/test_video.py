"""The commands video and snapshot."""

import av
import pytest
from PIL import Image

from rcj_challenges.cli.app import app
from rcj_challenges.facts.errors import RcjError
from rcj_challenges.records.testing import write_made_up_run
from rcj_challenges.views.video import errors, make


def run(*arguments):
    return app(list(map(str, arguments)), standalone_mode=False)


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    runs = tmp_path_factory.mktemp("runs")
    write_made_up_run(runs, ticks=500, halves=1)
    return runs


def test_a_video_is_written_where_asked_and_its_place_is_printed(runs, tmp_path, capsys):
    out = tmp_path / "v.mp4"
    code = run(
        "video", "--runs", runs, "--from", "12", "--to", "0:13", "--size", "320x180", "--fps", "10",
        "--renderer", "top", "--out", out,
    )  # fmt: skip
    told = capsys.readouterr()
    assert code == 0
    assert told.out.strip() == str(out)
    assert "from above by Pillow" in told.err
    with av.open(str(out)) as container:
        assert container.streams.video[0].frames == 10


def test_highlights_and_pictures_go_into_the_record_by_default(runs, capsys):
    (folder,) = runs.iterdir()
    options = ("--runs", runs, "--size", "320x180", "--renderer", "top")
    assert run("video", folder.name, "--highlights", "--fps", "5", "--quiet", *options) == 0
    assert run("snapshot", folder.name, "--at", "12.9", *options) == 0
    printed = capsys.readouterr().out.splitlines()
    assert printed == [str(folder / "highlights.mp4"), str(folder / "snapshot-half1-12.900s.png")]
    with av.open(printed[0]) as container:
        assert container.streams.video[0].frames == 35
    with Image.open(printed[1]) as picture:
        assert picture.size == (320, 180)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("snapshot", "--at", "999"), "beyond the end"),
        (("snapshot", "--at", "5", "--half", "2"), "no such half"),
        (("snapshot", "--at", "5", "--camera", "behind:Z1"), "no robot 'Z1'"),
        (("snapshot", "--at", "soon"), "is no time"),
        (("snapshot", "--at", "5", "--out", "picture.jpg"), r"end in \.png"),
        (("video", "--from", "9", "--to", "3"), "must be before"),
        (("video", "--size", "321x180"), "even"),
        (("video", "--fps", "0"), "1 to 240"),
        (("video", "--speed", "0"), "slow motion"),
        (("video", "--renderer", "gpu"), "auto, top, 3d"),
        (("video", "--out", "."), "is a folder"),
        (("video", "--out", "no/such/folder/v.mp4"), "there is no folder"),
        (("video", "nobody"), "nobody"),
    ],
)
def test_wrong_input_is_told_and_exits_with_2(runs, arguments, words, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(RcjError, match=words) as caught:
        run(*arguments, "--runs", runs)
    assert caught.value.exit_code == 2
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("arguments", [("video",), ("snapshot", "--at", "3")])
def test_without_the_extra_it_is_said_what_to_install_and_what_works_without(runs, arguments, monkeypatch):
    monkeypatch.setattr(errors, "find_spec", lambda _: None)
    with pytest.raises(RcjError, match=r'pip install "rcj-challenges\[video\]".*rcj-challenge view') as caught:
        run(*arguments, "--runs", runs)
    assert caught.value.exit_code == 2


def test_an_interrupted_video_is_told_with_where_it_is(runs, tmp_path, monkeypatch, capsys):
    frame = make.Studio.frame
    made = []

    def interrupted(self, moment):
        made.append(moment)
        if len(made) > 10:
            raise KeyboardInterrupt
        return frame(self, moment)

    monkeypatch.setattr(make.Studio, "frame", interrupted)
    out = tmp_path / "v.mp4"
    assert run("video", "--runs", runs, "--size", "320x180", "--fps", "10", "--renderer", "top", "-o", out) == 130
    assert "the first 1.0 s are kept" in capsys.readouterr().err
    assert [found.name for found in tmp_path.iterdir()] == ["v.part.mp4"]
