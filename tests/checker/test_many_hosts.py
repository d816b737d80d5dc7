"""What this computer cannot do is no verdict on a team: no space, no more files, no memory, no room for a replay."""

from __future__ import annotations

import errno
import json
import os
import tempfile
from dataclasses import replace
from pathlib import Path

import pytest

from rcj_challenges.checker import check as check_module
from rcj_challenges.checker import many, playing, report_files, starting
from rcj_challenges.checker.check import CheckOptions, check_file
from rcj_challenges.checker.many import check_many
from rcj_challenges.checker.report import check_report
from rcj_challenges.checker.report_html import html_page
from rcj_challenges.checker.report_text import summary, verdict
from rcj_challenges.facts.errors import HostError
from rcj_challenges.scenario.load import load
from tests.checker.small_team import PLAYER, write_team

ONE_ROBOT_EACH = [f"entrants.{seat}.robots.{seat[0].upper()}{n}=null" for seat in ("blue", "yellow") for n in (2, 3)]
MATCH = load("match", ["limits.start_s=10", "limits.step_s=1", *ONE_ROBOT_EACH])
SHORT = CheckOptions(play_s=0.5)
CRASHING = PLAYER.replace("pass", "open('log', 'w').write('x') and 1 / 0")


def no_space(*_, **__):
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def raising(error):
    def raises(*_, **__):
        raise error

    return raises


@pytest.fixture
def team(tmp_path):
    def packed(program=PLAYER, name="team.zip"):
        return write_team(tmp_path / name, program)

    return packed


def report(*files):
    return check_report("match", "SoccerSim match", "auto", list(files))


HOST_ERRORS = {
    "disk full": OSError(errno.ENOSPC, "No space left on device"),
    "too many open files": OSError(errno.EMFILE, "Too many open files"),
    "memory": MemoryError(),
    "told by the match": HostError("the program of B1 cannot be started here: No space left on device"),
}


@pytest.mark.parametrize("stage", ["inspect", "check_sources", "check_start", "check_play"])
@pytest.mark.parametrize("error", HOST_ERRORS.values(), ids=HOST_ERRORS)
def test_what_this_computer_cannot_do_is_no_verdict_on_a_team(team, monkeypatch, stage, error):
    module = {"check_start": starting, "check_play": playing}.get(stage, check_module)
    monkeypatch.setattr(module, stage, raising(error))
    told = check_file(team(), MATCH, SHORT)
    assert told.level == "unchecked"
    assert told.hindrance
    assert told.count("failure") == 0
    assert "It cannot play" not in verdict(told)


def test_a_temporary_folder_that_is_not_there_is_no_verdict_on_a_team(team, tmp_path, monkeypatch):
    path = team()
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "nowhere"))
    told = check_file(path, MATCH, SHORT)
    assert told.level == "unchecked"
    assert "temporary folder" in told.hindrance


def test_a_program_that_fails_while_the_temporary_folder_is_full_is_no_verdict_on_a_team(team, monkeypatch):
    path = team(CRASHING)
    assert check_file(path, MATCH, SHORT).level == "failure"
    monkeypatch.setattr(check_module, "ensure_room", no_space)
    assert check_file(path, MATCH, SHORT).level == "unchecked"


def test_an_unchecked_submission_is_told_as_such_everywhere_and_ends_with_2(team, monkeypatch, tmp_path):
    good = check_file(team(), MATCH, CheckOptions(play=False))
    bad = check_file(team("x = (\n"), MATCH, CheckOptions(play=False))
    monkeypatch.setattr(check_module, "check_sources", no_space)
    told = report(good, bad, check_file(team(), MATCH, SHORT))
    assert told.exit_code == 2
    assert summary(told) == "3 submissions: 1 ok, 0 warnings, 1 failure, 1 not checked"
    data = json.loads(json.dumps(told.model_dump(mode="json")))
    assert [file["level"] for file in data["files"]] == ["passed", "failure", "unchecked"]
    assert "No space left" in data["files"][2]["hindrance"]
    page = html_page(told, tmp_path)
    assert page.count(">not checked</span>") == 2
    assert "No space left" in page


def test_where_no_process_can_be_started_nothing_is_said_about_the_teams(team, monkeypatch):
    paths = [team(name="a.zip"), team(name="b.zip")]
    monkeypatch.setattr(many.subprocess, "Popen", raising(OSError(errno.EAGAIN, "Resource temporarily unavailable")))
    told = check_many(paths, MATCH, SHORT, 2, lambda _: None)
    assert [file.level for file in told] == ["unchecked", "unchecked"]


@pytest.mark.skipif(os.name != "posix", reason="there are no such signals")
def test_a_check_that_the_system_ends_for_want_of_memory_is_no_verdict(team, monkeypatch):
    monkeypatch.setattr(many, "_START", "import os; os.kill(os.getpid(), 9)")
    (told,) = check_many([team()], MATCH, SHORT, 1, lambda _: None)
    assert told.level == "unchecked"
    assert "memory" in told.hindrance


def test_a_replay_for_which_there_is_no_room_is_no_warning_of_the_team(team, tmp_path, monkeypatch):
    options = replace(SHORT, replays=tmp_path)
    before = check_file(team(), MATCH, SHORT)
    monkeypatch.setattr(check_module, "copy_page", no_space)
    told = check_file(team(), MATCH, options)
    assert (told.level, told.count("warning")) == (before.level, before.count("warning"))
    assert ["No space left" in match.no_replay for match in told.matches] == [True, True]
    assert report(told).exit_code == 2
    assert "2 replays not written" in summary(report(told))
    assert html_page(report(told), tmp_path).count("replay could not be written") == 2


def test_teams_of_the_same_file_name_get_their_own_pages(team, tmp_path):
    paths = [team(name="a/team.zip"), team(PLAYER + "# b\n", name="b/team.zip")]
    told = check_many(paths, MATCH, replace(SHORT, replays=tmp_path / "pages"), 2, lambda _: None)
    assert [file.file for file in told] == ["a/team.zip", "b/team.zip"]
    pages = {match.replay for file in told for match in file.matches}
    assert len(pages) == len(list((tmp_path / "pages").iterdir())) == 4


def test_an_old_page_stays_if_the_new_one_cannot_be_written_whole(tmp_path, monkeypatch):
    page = tmp_path / "report.html"
    page.write_text("old", encoding="utf-8")
    monkeypatch.setattr(os, "fsync", no_space)
    with pytest.raises(OSError, match="No space"):
        report_files.write_page(page, "new")
    with pytest.raises(OSError, match="No space"):
        report_files.copy_page(page, page)
    assert page.read_text(encoding="utf-8") == "old"
    assert list(tmp_path.iterdir()) == [page]


def test_a_page_can_go_to_a_device_and_through_a_link(tmp_path):
    if os.name != "posix":
        pytest.skip("there is no such device here")
    (tmp_path / "null").symlink_to(os.devnull)
    report_files.ensure_page(tmp_path / "null")
    report_files.write_page(tmp_path / "null", "text")
    (tmp_path / "link.html").symlink_to("page.html")
    report_files.write_page(tmp_path / "link.html", "text")
    assert (tmp_path / "link.html").is_symlink()
    assert (tmp_path / "page.html").read_text(encoding="utf-8") == "text"
    assert not Path(os.devnull).is_file()
