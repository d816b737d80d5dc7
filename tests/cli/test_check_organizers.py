"""``rcj-challenge check`` for an organizer: nothing is left out unsaid, nothing is lost, nothing begins in vain."""

from __future__ import annotations

import errno
import io
import json
import os
import signal
import subprocess
import sys
import tempfile
import time

import jsonschema
import pytest

from rcj_challenges.checker import many
from rcj_challenges.core.errors import HostError, RcjError
from rcj_challenges.match.runner import MatchInterruptedError, PlayedMatch
from scripts.write_schemas import check_text
from tests.checker.small_team import PLAYER, write_team
from tests.cli.conftest import ONE_ROBOT
from tests.cli.in_this_process import one_after_the_other
from tests.cli.test_check import check

COMMAND = [sys.executable, "-m", "rcj_challenges", "check"]
SLOW = "import _thread\nlock = _thread.allocate_lock()\nlock.acquire()\nlock.acquire()\n"
"""Never steps, and needs no processor for that: others run beside this test."""


@pytest.fixture
def team(tmp_path):
    def packed(name, program=PLAYER):
        return write_team(tmp_path / name, program)

    return packed


def never(*_, **__):
    raise AssertionError("nothing was to be checked")


@pytest.mark.parametrize("as_json", [True, False])
def test_the_page_is_written_also_if_there_is_no_room_for_what_is_printed(team, tmp_path, monkeypatch, as_json):
    """``check teams --html report.html > told.txt``: what took an hour is not lost."""

    class Full(io.StringIO):
        def write(self, _):
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(sys, "stdout", Full())
    with pytest.raises((OSError, HostError), match=os.strerror(errno.ENOSPC)):
        check(team("a.zip"), html=tmp_path / "report.html", json_=as_json, play=False)
    assert "a.zip" in (tmp_path / "report.html").read_text("utf-8")


def test_with_one_archive_the_rest_of_the_folder_is_named_too(team, tmp_path, capsys):
    team("subs/a.zip")
    (tmp_path / "subs" / ".hidden.zip").write_bytes(b"PK")
    check(tmp_path / "subs", html=tmp_path / "report.html")
    assert ".hidden.zip: its name begins with a dot" in capsys.readouterr().out
    assert ".hidden.zip" in (tmp_path / "report.html").read_text("utf-8")


@pytest.fixture
def nothing_is_checked(monkeypatch):
    monkeypatch.setattr("rcj_challenges.checker.check.check_file", never)


@pytest.mark.usefixtures("nothing_is_checked")
def test_replays_that_cannot_be_kept_are_refused_before_anything_is_played(team, tmp_path, monkeypatch):
    good = team("a.zip")
    (tmp_path / "taken").write_text("a file", encoding="utf-8")
    with pytest.raises(RcjError, match=r"taken: cannot be written: .* file"):
        check(good, replay=tmp_path / "taken", play=True)

    def full(*_, **__):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(tempfile, "TemporaryFile", full)
    with pytest.raises(RcjError, match="No space left on device") as printed:
        check(good, replay=tmp_path / "replays", play=True)
    assert printed.value.exit_code == 2


@pytest.mark.usefixtures("nothing_is_checked")
def test_a_page_that_cannot_be_written_is_refused_before_anything_is_checked(team, tmp_path):
    good = team("a.zip")
    with pytest.raises(RcjError, match="it is a folder"):
        check(good, html=tmp_path)
    with pytest.raises(RcjError, match="cannot be written"):
        check(good, html=good / "report.html")


@pytest.mark.parametrize("as_json", [True, False])
def test_interruption_reports_what_was_checked_so_far(team, tmp_path, monkeypatch, capsys, as_json):
    paths = [team("slow.zip"), team("fast.zip")]

    def interrupted(given, loaded, options, jobs, on_done):
        one_after_the_other(given[1:], loaded, options, jobs, on_done)
        raise KeyboardInterrupt

    monkeypatch.setattr(many, "check_many", interrupted)
    with pytest.raises(KeyboardInterrupt):
        check(*paths, html=tmp_path / "report.html", json_=as_json)
    assert "interrupted, 1 submission: 1 ok" in (tmp_path / "report.html").read_text("utf-8")
    out = capsys.readouterr().out
    if not as_json:
        assert "interrupted, 1 submission: 1 ok, 0 warnings, 0 errors, 1 not looked at" in out
        return
    report = json.loads(out)
    assert (report["interrupted"], report["level"]) == (True, "unchecked")
    assert [file["file"] for file in report["files"]] == ["fast.zip"]
    assert [other["file"] for other in report["left_out"]] == ["slow.zip"]


def test_interruption_of_the_only_check_names_no_folder_that_is_gone(team, tmp_path, monkeypatch, capsys):
    def interrupted(*_):
        raise MatchInterruptedError(PlayedMatch(tmp_path / "temporary" / "20210618-001159-match", {}), "")

    monkeypatch.setattr("rcj_challenges.checker.check.check_file", interrupted)
    with pytest.raises(KeyboardInterrupt) as ended:
        check(team("slow.zip"), json_=True)
    assert str(ended.value) == ""
    report = json.loads(capsys.readouterr().out)
    assert (report["interrupted"], report["files"]) == (True, [])
    assert [other["file"] for other in report["left_out"]] == ["slow.zip"]


@pytest.mark.skipif(os.name != "posix", reason="there are no such signals")
def test_ctrl_c_ends_with_130_a_report_in_json_and_no_temporary_folder(team, tmp_path):
    """The one test of several submissions with the command, its pipes and all processes as users have them."""
    paths = [
        team("bad.zip", "x = (\n"),
        team("slow_1.zip", SLOW),
        team("slow_2.zip", SLOW),
    ]
    temporary = tmp_path / "temporary"
    temporary.mkdir()
    command = [*COMMAND, *map(str, paths), "--html", str(tmp_path / "report.html"), "--jobs", "2", "--json"]
    command += ONE_ROBOT
    with subprocess.Popen(
        command,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        encoding="utf-8",
        env={**os.environ, "TMPDIR": str(temporary)},
        start_new_session=True,
    ) as process:
        until = time.monotonic() + 60
        # Two for each that is tried on both sides: with the third one the second has begun, so the first is done.
        while len(list(temporary.glob("rcj-match-*"))) < 3 and time.monotonic() < until:
            time.sleep(0.1)
        time.sleep(0.5)  # its verdict may still be on its way
        os.killpg(process.pid, signal.SIGINT)  # as a terminal does: to all processes
        out, err = process.communicate(timeout=120)
    assert process.returncode == 130, err
    report = json.loads(out)  # and nothing else
    jsonschema.validate(report, json.loads(check_text()))
    assert [(file["file"], file["level"]) for file in report["files"]] == [("bad.zip", "error")]
    assert [other["file"] for other in report["left_out"]] == ["slow_1.zip", "slow_2.zip"]
    page = (tmp_path / "report.html").read_text("utf-8")
    assert "interrupted, 1 submission: 0 ok, 0 warnings, 1 error" in page
    assert "slow_1.zip" in page
    assert list(temporary.iterdir()) == []
