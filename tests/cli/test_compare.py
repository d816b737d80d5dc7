"""``compare`` plays two versions of a team with the same seeds, and reports whether the difference is more than chance."""

import json
from dataclasses import replace

import pytest

from rcj_challenges.match import worker_pool
from tests.cli.conftest import ONE_ROBOT, STAND
from tests.cli.in_this_process import here, played_one_after_the_other

STOOD_STILL = """
schema_version: 2
id: stood_still
title: Stood still
extends: match
match: {halves: 1, half_s: 0.5, swap_sides: false}
rules:
  stood_still:
    triggers: [{trigger: no_progress, entity: Y1, distance_m: 0.001, within_s: 0.4}]
    actions: [{action: score, entrant: blue, points: 1}]
    says: A point for blue.
"""
DRIVE = STAND.replace("while", "robot.getDevice('left wheel motor').setPosition(float('inf'))\nwhile", 1).replace(
    "    pass", "    robot.getDevice('left wheel motor').setVelocity(10)"
)


def unspoilt(outcome, _):
    return outcome


@pytest.fixture
def compare(tmp_path, monkeypatch, capsys):
    """Compare teams; returns the seeds that were played, the exit code, and what was printed."""
    for name, program in (("stand", STAND), ("drive", DRIVE), ("opponent", STAND)):
        (tmp_path / f"{name}.py").write_text(program, "utf-8")
    (tmp_path / "stood_still.yaml").write_text(STOOD_STILL, "utf-8")

    def compared(new, old, *more, spoil=unspoilt):
        played = []

        def play(jobs, at_once, on_done):
            outcomes = played_one_after_the_other(jobs, at_once, on_done)
            outcomes = [spoil(outcome, outcome.job in played) for outcome in outcomes]
            played.extend(jobs)
            return outcomes

        monkeypatch.setattr(worker_pool, "run_all", play)
        options = ("--scenario=stood_still.yaml", "--against=opponent.py", *ONE_ROBOT, "--quiet")
        code = here(monkeypatch, tmp_path, "compare", new, old, *options, *more)
        return [job.seed for job in played], code, capsys.readouterr()

    return compared


def test_the_version_that_does_better_with_each_seed_is_better(compare, tmp_path):
    _, code, printed = compare("drive.py", "stand.py", "--seeds=1..6", "--json")
    report = json.loads(printed.out)
    assert (code, report["verdict"], report["better"], report["failed"]) == (0, "better", 6, [])
    assert [seed["gains"] for seed in report["seeds"]] == [[1]] * 6
    assert (report["new"]["drawn"], report["old"]["lost"], report["old"]["conceded"]) == (6, 6, 6)
    pages = [
        seed[version]["replay"] for seed in report["seeds"] for version in ("new", "old") if "replay" in seed[version]
    ]
    assert len(pages) == len(set(pages)) == 6
    assert all((tmp_path / page).is_file() for page in pages)


def test_what_was_played_before_is_not_played_again(compare):
    assert compare("stand.py", "stand.py", "--seeds=1,2")[0] == [1, 2]
    played, _, printed = compare("drive.py", "stand.py", "--seeds=1..3")
    assert sorted(played) == [1, 2, 3, 3]
    lines = printed.out.splitlines()
    assert [line for line in lines if line.startswith("seed 3")] == [
        "seed 3, new: opponent 0 : 0 drive",
        "seed 3, old: opponent 1 : 0 stand",
    ]
    assert lines[-1].startswith("better in 3 of 3 seeds: could be chance")


@pytest.mark.parametrize(
    "fault", [{"result": None, "complaint": "killed"}, {"result": {"faults": [{"kind": "step_timeout"}]}}]
)
def test_a_match_that_a_busy_computer_spoilt_is_played_again(compare, fault):
    def spoil(outcome, again):
        return replace(outcome, **fault) if outcome.job.seed == 2 and not again else outcome

    played, code, printed = compare("drive.py", "stand.py", "--seeds=1..3", "--json", spoil=spoil)
    assert sorted(played) == [1, 1, 2, 2, 2, 2, 3, 3]
    assert (code, json.loads(printed.out)["better"]) == (0, 3)


def test_a_seed_that_cannot_be_played_is_left_out_and_reported(compare):
    def spoil(outcome, again):
        return replace(outcome, result=None, complaint="killed") if outcome.job.seed == 2 else outcome

    _, code, printed = compare("drive.py", "stand.py", "--seeds=1..3", "--json", spoil=spoil)
    report = json.loads(printed.out)
    assert (code, [seed["seed"] for seed in report["seeds"]]) == (3, [1, 3])
    assert report["failed"] == [{"seed": 2, "message": "killed"}] * 2


@pytest.mark.parametrize("more", [("--against=opponent.py", "--scenario=slalom"), ("--scenario=stood_still.yaml",)])
def test_an_opponent_is_named_where_there_is_one(compare, tmp_path, monkeypatch, capsys, more):
    assert here(monkeypatch, tmp_path, "compare", "drive.py", "stand.py", *more) == 2
    assert "error[option-does-not-fit]" in capsys.readouterr().err
