"""What this computer cannot do is no verdict on a team: no space, no more files, no memory, no room for a replay."""

from __future__ import annotations

import errno
import io
import json
import os
import tempfile
from dataclasses import replace
from pathlib import Path

import jsonschema
import pytest
from rich.console import Console

from rcj_challenges.checker import check as check_module
from rcj_challenges.checker import many, playing, report_files, starting
from rcj_challenges.checker.check import CheckOptions, check_file, crashed_report
from rcj_challenges.checker.discovery import name_submissions
from rcj_challenges.checker.many import check_many
from rcj_challenges.checker.report import check_report, summary, verdict
from rcj_challenges.checker.report_html import html_page
from rcj_challenges.checker.report_text import print_report
from rcj_challenges.core.errors import HostError
from rcj_challenges.records.codes import RECORD_DAMAGED
from rcj_challenges.records.errors import RecordError
from rcj_challenges.scenario.load import load
from rcj_challenges.world.errors import PhysicsFault
from scripts.write_schemas import check_text
from tests.checker.alone import ONE_EACH, alone
from tests.checker.small_team import PLAYER, write_team

LIMITS = ("limits.start_s=10", "limits.step_s=1")
MATCH, ALONE = load("match", [*LIMITS, *ONE_EACH]), alone(*LIMITS)
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
    "reported by the match": HostError("the program of B1 cannot be started here: No space left on device"),
}


@pytest.mark.parametrize("stage", ["inspect", "check_sources", "check_start", "check_play"])
@pytest.mark.parametrize("error", HOST_ERRORS.values(), ids=HOST_ERRORS)
def test_what_this_computer_cannot_do_is_no_verdict_on_a_team(team, monkeypatch, stage, error):
    module = {"check_start": starting, "check_play": playing}.get(stage, check_module)
    monkeypatch.setattr(module, stage, raising(error))
    checked = check_file(team(), MATCH, SHORT)
    assert checked.level == "unchecked"
    assert checked.blocked_by
    assert checked.count("error") == 0
    assert "It cannot play" not in verdict(checked)


def test_a_temporary_folder_that_is_not_there_is_no_verdict_on_a_team(team, tmp_path, monkeypatch):
    path = team()
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "nowhere"))
    checked = check_file(path, MATCH, SHORT)
    assert (checked.level, checked.code) == ("unchecked", "temporary-folder")


def test_a_program_that_fails_while_the_temporary_folder_is_full_is_no_verdict_on_a_team(team, monkeypatch):
    path = team(CRASHING)
    assert check_file(path, ALONE, SHORT).level == "error"
    monkeypatch.setattr(check_module, "ensure_room", no_space)
    assert check_file(path, ALONE, SHORT).level == "unchecked"


def test_a_fault_of_ours_is_reported_as_such_everywhere_and_ends_with_3(team, monkeypatch, tmp_path):
    bad = check_file(team("x = (\n"), MATCH, CheckOptions(play=False))
    monkeypatch.setattr(starting, "check_start", raising(KeyError("left")))
    stumbled = check_file(team(), MATCH, SHORT)
    monkeypatch.setattr(check_module, "check_sources", no_space)
    checked = report(
        bad, stumbled, check_file(team(), MATCH, SHORT), crashed_report(name_submissions([team()])[0], "it died")
    )
    assert (checked.exit_code, checked.level) == (3, "unchecked")
    assert summary(checked) == "4 submissions: 0 ok, 0 warnings, 1 error, 3 not checked"
    assert "a fault of the check itself and says nothing about the team" in verdict(stumbled)
    data = json.loads(json.dumps(checked.model_dump(mode="json")))
    assert [file["level"] for file in data["files"]] == ["error", "unchecked", "unchecked", "unchecked"]
    jsonschema.validate(data, json.loads(check_text()))
    page = html_page(checked, tmp_path)
    assert page.count(">not checked</span>") == 8  # three in the table, three in the heads, two stages
    stream = io.StringIO()
    print_report(Console(file=stream, width=100), checked)
    assert "not checked  start: every robot starts" in stream.getvalue()


@pytest.mark.parametrize(
    ("error", "exit_code"), [(PhysicsFault("cannot go on"), 3), (RecordError(RECORD_DAMAGED, "cannot go on"), 2)]
)
def test_a_match_that_cannot_be_played_is_no_verdict(team, monkeypatch, error, exit_code):
    monkeypatch.setattr(starting, "check_start", raising(error))
    checked = check_file(team(), MATCH, SHORT)
    assert (checked.level, checked.blocked_by) == ("unchecked", "cannot go on")
    assert [finding.code for stage in checked.stages for finding in stage.findings][-1] == "check.impossible"
    assert report(checked).exit_code == exit_code


def test_submissions_are_unchecked_if_no_process_can_be_started(team, monkeypatch):
    paths = [team(name="a.zip"), team(name="b.zip")]
    monkeypatch.setattr(many.subprocess, "Popen", raising(OSError(errno.EAGAIN, "Resource temporarily unavailable")))
    checked = check_many(paths, MATCH, SHORT, 2, lambda _: None)
    assert [file.level for file in checked] == ["unchecked", "unchecked"]


@pytest.mark.skipif(os.name != "posix", reason="there are no such signals")
def test_a_check_that_the_system_ends_for_want_of_memory_is_no_verdict(team, monkeypatch):
    monkeypatch.setattr(many, "_START", "import os; os.kill(os.getpid(), 9)")
    (checked,) = check_many([team()], MATCH, SHORT, 1, lambda _: None)
    assert checked.level == "unchecked"
    assert "memory" in checked.blocked_by


@pytest.mark.nightly
def test_a_replay_for_which_there_is_no_room_is_no_warning_of_the_team(team, tmp_path, monkeypatch):
    options = replace(SHORT, replays=tmp_path)
    before = check_file(team(), MATCH, SHORT)
    monkeypatch.setattr(check_module, "write_page", no_space)
    checked = check_file(team(), MATCH, options)
    assert (checked.level, checked.count("warning")) == (before.level, before.count("warning"))
    assert ["No space left" in match.no_replay for match in checked.matches] == [True, True]
    assert all(str(tmp_path) in match.no_replay and "make room there" in match.no_replay for match in checked.matches)
    assert report(checked).exit_code == 2
    assert "2 replays not written" in summary(report(checked))
    assert html_page(report(checked), tmp_path).count("replay could not be written") == 2


@pytest.mark.nightly
def test_teams_of_the_same_file_name_get_their_own_pages(team, tmp_path):
    paths = [team(name="a/team.zip"), team(PLAYER + "# b\n", name="b/team.zip")]
    checked = check_many(paths, ALONE, replace(SHORT, replays=tmp_path / "pages"), 2, lambda _: None)
    assert [file.file for file in checked] == ["a/team.zip", "b/team.zip"]
    pages = {match.replay for file in checked for match in file.matches}
    assert len(pages) == len(list((tmp_path / "pages").iterdir())) == 2


def test_an_old_page_stays_if_the_new_one_cannot_be_written_whole(tmp_path, monkeypatch):
    page = tmp_path / "report.html"
    page.write_text("old", encoding="utf-8")
    monkeypatch.setattr(os, "fsync", no_space)
    with pytest.raises(OSError, match="No space"):
        report_files.write_page(page, "new")
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
