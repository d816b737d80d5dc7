"""``simulate --out`` remembers what it has played, and ``verify`` plays it again."""

import json
from pathlib import Path

import pytest

from rcj_challenges.match import worker_pool
from tests.cli.conftest import ONE_ROBOT, STAND
from tests.cli.in_this_process import here, played_one_after_the_other

DUEL = [
    *ONE_ROBOT,
    "--set=match.half_s=0.2", "--set=match.halves=1", "--set=match.swap_sides=false",
]  # fmt: skip


@pytest.fixture
def simulate(tmp_path, monkeypatch, capsys):
    """Simulate seeds; returns which seeds were really played, and the summary."""
    for name in ("ada", "bee"):
        (tmp_path / f"{name}.py").write_text(STAND, "utf-8")

    def simulated(seeds, *more, blue="ada.py"):
        played = []

        def play(jobs, at_once, on_done):
            played.extend(job.seed for job in jobs)
            return played_one_after_the_other(jobs, at_once, on_done)

        monkeypatch.setattr(worker_pool, "run_all", play)
        teams = ("--team", f"blue={blue}", "--team", "yellow=bee.py")
        assert here(monkeypatch, tmp_path, "simulate", "match", "--seeds", seeds, *teams, *DUEL, *more, "--json") == 0
        return played, json.loads(capsys.readouterr().out)

    return simulated


def test_only_seeds_are_played_of_which_there_is_no_record(simulate):
    first = simulate("1,2")
    again, printed = simulate("1..3")
    assert (first[0], again) == ([1, 2], [3])
    assert [one["seed"] for one in printed["scores"]] == [1, 2, 3]
    assert printed["records"][:2] == first[1]["records"]


def test_other_programs_settings_or_damaged_records_are_played_again(simulate, tmp_path):
    _, printed = simulate("1,2")
    (tmp_path / "cid.py").write_text(STAND + "# another\n", "utf-8")
    assert simulate("1", blue="cid.py")[0] == [1]
    assert simulate("1", "--set=match.half_s=0.3")[0] == [1]
    result = tmp_path / Path(printed["records"][0]["folder"]) / "result.json"
    result.write_bytes(result.read_bytes()[:-9])
    assert simulate("1,2")[0] == [1]


def test_verify_plays_a_record_again_with_the_programs_that_are_given(simulate, tmp_path, monkeypatch, capsys):
    _, printed = simulate("1")
    record = printed["records"][0]["folder"]
    assert here(monkeypatch, tmp_path, "verify", record) == 2
    assert "error[programs-missing]" in capsys.readouterr().err
    for given, code in (("keper", "unknown-team"), ("gone.zip", "no-such-file")):
        assert here(monkeypatch, tmp_path, "verify", record, "--team", given) == 2
        assert f"error[{code}]" in capsys.readouterr().err
    teams = ("--team", "ada.py", "--team", "bee.py", "--team", "keeper")
    assert here(monkeypatch, tmp_path, "verify", record, *teams, "--json") == 0
    assert [one["verdict"] for one in json.loads(capsys.readouterr().out)] == ["same"]
    result = tmp_path / record / "result.json"
    digest = printed["records"][0]["digest"]
    result.write_text(result.read_text("utf-8").replace(digest, digest[::-1]), "utf-8")
    assert here(monkeypatch, tmp_path, "verify", record, *teams) == 1
