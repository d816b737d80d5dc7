"""``rcj-challenge check`` as its users meet it: verdicts, exit codes, and no byte string that makes it stumble."""

from __future__ import annotations

import io
import json
import subprocess
import sys
import zipfile
from pathlib import Path

import jsonschema
import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.checker import many
from rcj_challenges.cli import check as check_command
from rcj_challenges.core.errors import RcjError
from scripts.write_schemas import check_text
from tests.cli.in_this_process import one_after_the_other

COMMAND = [sys.executable, "-m", "rcj_challenges", "check"]
PLAYER = """\
from controller import Robot
robot = Robot()
for name in ("left wheel motor", "right wheel motor"):
    robot.getDevice(name).setPosition(float("inf"))
while robot.step(32) != -1:
    pass
"""


def archive(program=PLAYER, name="Hanse"):
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as file:
        file.writestr("rcj_soccer_team_blue/rcj_soccer_team_blue.py", program)
        file.writestr("team_name.txt", name)
    return data.getvalue()


@pytest.fixture
def good(tmp_path):
    path = tmp_path / "good.zip"
    path.write_bytes(archive())
    return path


@pytest.fixture
def bad(tmp_path):
    path = tmp_path / "bad.zip"
    path.write_bytes(archive("x = (\n", "\u202eevil\x1b[2J"))
    return path


def command(*arguments, cwd):
    return subprocess.run(
        [*COMMAND, *map(str, arguments)], cwd=cwd, capture_output=True, encoding="utf-8", timeout=120, check=False
    )


def check(*paths, **options):
    """Check in this process; by default without running programs."""
    return check_command.check(list(paths), **{"play": False, **options})


def test_a_good_submission_is_played_and_ends_with_0(tmp_path, good):
    done = command(good, "--html", "out/report.html", "--replay", "replays", "--set", "match.half_s=1", cwd=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "It will play" in done.stdout
    assert (tmp_path / "out" / "report.html").read_text("utf-8").startswith("<!doctype html>")
    assert sorted(path.name for path in (tmp_path / "replays").iterdir()) == ["good-blue.html", "good-yellow.html"]


def test_a_bad_submission_exits_with_1_and_prints_help(bad, capsys):
    assert check(bad, play=True) == 1
    out, err = capsys.readouterr()
    assert "rcj_soccer_team_blue/rcj_soccer_team_blue.py:1:5" in out
    assert not set(out) & set("\x1b\u202e")
    assert err == ""


def test_json_prints_the_report_and_nothing_else(good, bad, capsys, monkeypatch):
    monkeypatch.setattr(many, "check_many", one_after_the_other)
    assert check(good, bad, json_=True) == 1
    out, err = capsys.readouterr()
    assert err == ""
    report = json.loads(out)
    jsonschema.validate(report, json.loads(check_text()))
    assert [file["level"] for file in report["files"]] == ["passed", "error"]
    assert report["summary"] == {"files": 2, "passed": 1, "warning": 0, "error": 1, "unchecked": 0}


def test_several_submissions_give_a_table_and_a_summary(good, bad, capsys, monkeypatch):
    monkeypatch.setattr(many, "check_many", one_after_the_other)
    assert check(good, bad) == 1
    out, err = capsys.readouterr()
    assert "2 submissions: 1 ok, 0 warnings, 1 error" in out
    assert "2/2" in err


def test_a_path_that_cannot_be_opened_ends_with_2(tmp_path, good):
    done = command(good, "\u202enowhere.zip", cwd=tmp_path)
    assert done.returncode == 2
    assert "\\u202enowhere.zip: cannot be opened" in done.stderr
    assert done.stdout == ""


@pytest.mark.parametrize("path", ["/dev/zero", "a\0b"])
def test_what_is_no_file_is_not_read(path):
    with pytest.raises(RcjError) as refused:
        check(Path(path))
    assert refused.value.code == "cannot-open"


WRONG = {
    "no such scenario": {"scenario": "matsch"},
    "no such value": {"set_": ["half_z=3"]},
    "no such sandbox": {"sandbox": "maybe"},
}


@pytest.mark.parametrize("options", WRONG.values(), ids=WRONG)
def test_wrong_usage_ends_with_2(good, options):
    with pytest.raises(RcjError) as refused:
        check(good, **options)
    assert refused.value.exit_code == 2


def test_fix_writes_a_repaired_archive_and_checks_that_one(tmp_path, capsys):
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as file:
        file.writestr("our team/rcj_soccer_team_blue/rcj_soccer_team_blue.py", PLAYER)
        file.writestr("our team/Team Name.txt", "Hanse")
        file.writestr("__MACOSX/our team/._x", "x")
    (tmp_path / "team.zip").write_bytes(data.getvalue())
    assert check(tmp_path / "team.zip", fix=tmp_path / "fixed.zip") == 0
    out = capsys.readouterr().out
    assert "repaired: " in out
    assert out.startswith("fixed.zip  Hanse")
    with zipfile.ZipFile(tmp_path / "fixed.zip") as fixed:
        assert "rcj_soccer_team_blue/rcj_soccer_team_blue.py" in fixed.namelist()


def test_fix_repairs_one_at_a_time(tmp_path, good, bad):
    with pytest.raises(RcjError, match="one submission at a time"):
        check(good, bad, fix=tmp_path / "fixed.zip")


def test_an_option_in_the_place_of_what_fix_is_to_write_is_none(tmp_path, monkeypatch, good):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(RcjError, match="the name of the ZIP to write is missing"):
        check(good, fix=Path("--no-play"))
    assert not (tmp_path / "--no-play").exists()


GOOD = archive()


@given(
    st.binary(max_size=300)
    | st.tuples(st.integers(0, len(GOOD) - 1), st.binary(max_size=8)).map(
        lambda change: GOOD[: change[0]] + change[1] + GOOD[change[0] + len(change[1]) :]
    )
)
def test_any_bytes_get_a_verdict(tmp_path_factory, data):
    path: Path = tmp_path_factory.getbasetemp() / "any.zip"
    path.write_bytes(data)
    assert check(path) in (0, 1)
