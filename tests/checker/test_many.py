"""Many submissions at once: each in a process of its own, and what happens to one is not the others' loss."""

from __future__ import annotations

import time
import zipfile

import pytest

from rcj_challenges.checker import many
from rcj_challenges.checker.check import CheckOptions
from rcj_challenges.checker.many import check_many
from rcj_challenges.scenario.load import load

MATCH = load("match")
UNPLAYED = CheckOptions(play=False)
# Stands before what a worker runs.
DIES = "import os, sys, json; data = sys.stdin.buffer.read(); 'boom' in json.loads(data)['path'] and os.abort(); "
GOES_ON = "import io; sys.stdin = io.TextIOWrapper(io.BytesIO(data)); "
SLEEPS = "import sys, time; sys.stdin.buffer.read(); time.sleep(600)"


@pytest.fixture
def pack(tmp_path):
    def packed(name, program="x = 1\n"):
        path = tmp_path / name
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr("robot.py", program)
            archive.writestr("team_name.txt", name)
        return path

    return packed


def test_reports_come_as_they_are_ready_and_are_returned_in_order(pack):
    paths = [pack("c.zip"), pack("a.zip", "x = (\n"), pack("b.zip")]
    seen = []
    reports = check_many(paths, MATCH, UNPLAYED, 2, lambda report: seen.append(report.file))
    assert [report.file for report in reports] == ["c.zip", "a.zip", "b.zip"]
    assert [report.level == "error" for report in reports] == [False, True, False]
    assert sorted(seen) == ["a.zip", "b.zip", "c.zip"]


def test_a_check_that_dies_is_a_verdict_and_takes_no_other_with_it(pack, monkeypatch):
    monkeypatch.setattr(many, "_START", DIES + GOES_ON + many._START)
    reports = check_many([pack("boom.zip"), pack("sane.zip")], MATCH, UNPLAYED, 2, lambda _: None)
    found = reports[0].stages[0].findings[0]
    assert found.code == "check.broken"
    assert "bad end" in found.message
    assert reports[1].team == "sane.zip"


def test_a_submission_that_is_gone_when_its_turn_comes_is_no_fault_of_its_team(tmp_path):
    (report,) = check_many([tmp_path / "gone.zip"], MATCH, UNPLAYED, 1, lambda _: None)
    assert report.level == "unchecked"
    assert "there is no such file" in report.blocked_by


def test_a_check_that_does_not_end_is_ended(pack, monkeypatch):
    monkeypatch.setattr(many, "_START", SLEEPS)
    monkeypatch.setattr(many, "_SLACK_S", 0.3)
    monkeypatch.setattr(many, "_MAX_SHORT_MATCHES", 0)
    (report,) = check_many([pack("a.zip")], MATCH, UNPLAYED, 1, lambda _: None)
    assert "did not end" in report.stages[0].findings[0].message


def test_an_interruption_ends_the_running_checks(pack, monkeypatch):
    monkeypatch.setattr(
        many, "_START", "import json, sys, time; 'slow' in json.load(sys.stdin)['path'] and time.sleep(600)"
    )
    paths = [pack("slow_1.zip"), pack("fast.zip"), pack("slow_2.zip")]

    def interrupt(report):
        raise KeyboardInterrupt

    began = time.perf_counter()
    with pytest.raises(KeyboardInterrupt):
        check_many(paths, MATCH, UNPLAYED, 2, interrupt)
    assert time.perf_counter() - began < 60
