"""The smaller commands: view, replay, schema, draw, sheet, simulate."""

import errno
import io
import json
import os
import sys
from pathlib import Path

import pytest

from rcj_challenges.cli.commands import load_app
from rcj_challenges.core.errors import RcjError
from rcj_challenges.match import worker_pool
from rcj_challenges.match.batch import Job, Outcome
from rcj_challenges.views.replay.browse import address_of, playing_address
from tests.cli.conftest import ONE_ROBOT, STAND
from tests.cli.in_this_process import played_one_after_the_other
from tests.made_up_runs import write_made_up_run

BALL_CHASER = Path(__file__).parents[2] / "examples/teams/ball_chaser"


def run(*arguments):
    return load_app()(list(map(str, arguments)), standalone_mode=False)


@pytest.fixture
def runs(tmp_path):
    write_made_up_run(tmp_path / "runs")
    return tmp_path / "runs"


def test_the_list_names_each_record_with_its_score(runs, capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "120")
    (folder,) = runs.iterdir()
    assert run("view", "--list", "--out", runs) == 0
    assert folder.name in capsys.readouterr().out


def test_a_damaged_record_is_listed_with_what_is_wrong(runs, capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "160")
    (folder,) = runs.iterdir()
    (folder / "result.json").write_text("{", encoding="utf-8")
    assert run("view", "--list", "--out", runs) == 0
    assert "cannot be read" in capsys.readouterr().out


def test_replay_rewrites_the_page_of_the_newest_record(runs, capsys):
    (folder,) = runs.iterdir()
    (folder / "replay.html").unlink(missing_ok=True)
    assert run("replay", "--out", runs) == 0
    assert (folder / "replay.html").is_file()
    assert "replay.html" in capsys.readouterr().out


def test_a_record_that_is_not_there_is_reported(runs):
    with pytest.raises(RcjError, match="nowhere"):
        run("replay", "nowhere", "--out", runs)


def test_view_opens_the_page_and_prints_its_path(runs, capsys, monkeypatch):
    opened = []
    monkeypatch.setattr("webbrowser.open", lambda address, *_, **__: bool(opened.append(address)) or True)
    assert run("view", "--out", runs) == 0
    assert opened
    assert opened[0].startswith("file://") is (sys.platform != "win32")
    assert opened[0].endswith("play.html" if sys.platform in ("win32", "darwin") else "replay.html#play")


def test_a_browser_is_given_a_page_as_its_system_finds_it_also_in_a_folder_with_umlauts(tmp_path):
    page = tmp_path / "Jörg Müller" / "100% #1" / "replay.html"
    assert address_of(page, "win32") == str(page)
    assert address_of(page, "linux").endswith("/J%C3%B6rg%20M%C3%BCller/100%25%20%231/replay.html")
    assert address_of(page, "darwin") == address_of(page, "linux") == page.as_uri()


def test_a_replay_plays_by_itself_also_where_the_system_drops_the_fragment_of_an_address(tmp_path):
    page = tmp_path / "replay.html"
    for system in ("win32", "darwin"):
        assert playing_address(page, system) == address_of(tmp_path / "play.html", system)
    assert "url=replay.html#play" in (tmp_path / "play.html").read_text("utf-8")
    assert playing_address(tmp_path / "nowhere" / "replay.html", "win32") == str(tmp_path / "nowhere" / "replay.html")


def test_simulate_plays_every_seed_and_reports_the_spread(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(worker_pool, "run_all", played_one_after_the_other)
    team = tmp_path / "team.py"
    team.write_text(STAND, "utf-8")
    code = run(
        "simulate", "match", "--seeds", "1,2", "--team", f"blue={team}", "--team", f"yellow={team}", *ONE_ROBOT,
        "--set", "match.half_s=0.5", "--set", "match.halves=1", "--out", tmp_path / "runs", "--json",
    )  # fmt: skip
    printed = json.loads(capsys.readouterr().out)
    assert code == 0
    assert printed["played"] == 2
    assert [entry["seed"] for entry in printed["scores"]] == [1, 2]
    assert printed["spread"]["blue"]["most"] == 0
    assert printed["events"]["KICKOFF"] == 2
    assert [entry["seed"] for entry in printed["records"]] == [1, 2]  # to show a team what a score of it came from
    for entry in printed["records"]:
        result = json.loads((Path(entry["folder"]) / "result.json").read_text("utf-8"))
        assert all(result[key] == entry[key] for key in ("seed", "inputs", "states", "digest"))


def test_simulate_isolates_programs_as_run_does(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(worker_pool, "run_all", played_one_after_the_other)
    out = tmp_path / "runs"
    run(
        "simulate", "match", "--seeds", "1", "--duration", "0.1", *ONE_ROBOT, "--out", out, "--sandbox", "off", "--json"
    )
    (played,) = json.loads(capsys.readouterr().out)["records"]
    result = json.loads((Path(played["folder"]) / "result.json").read_text("utf-8"))
    assert result["sandbox"]["mode"] == "off"


def test_simulate_plays_nothing_in_a_sandbox_that_there_is_not(tmp_path, monkeypatch):
    monkeypatch.setattr(worker_pool, "run_all", lambda *_: pytest.fail("a match was begun"))
    with pytest.raises(RcjError, match="unknown sandbox 'loose'"):
        run("simulate", "match", "--seeds", "1..9", "--sandbox", "loose", "--out", tmp_path / "runs")


def outcome(seed, score=None, *, wrong_input=True):
    result = {"score": {"blue": score}, "events": [], "faults": [], "folder": f"runs/{seed}"}
    result |= {"inputs": "1", "states": "2", "digest": "3"}
    result = None if score is None else result
    return Outcome(Job(seed, ()), result, "" if score is not None else "No space left on device", wrong_input)


@pytest.mark.parametrize(("wrong_input", "code"), [(True, 2), (False, 3)], ids=["this computer's", "ours"])
def test_simulate_prints_the_matches_played_before_the_disk_was_full(monkeypatch, capsys, wrong_input, code):
    outcomes = [outcome(1, 7), outcome(2, wrong_input=wrong_input), outcome(3, wrong_input=wrong_input)]
    monkeypatch.setattr(worker_pool, "run_all", lambda *_: outcomes)
    assert run("simulate", "match", "--seeds", "1..3", "--json") == code
    printed = json.loads(capsys.readouterr().out)
    assert printed["scores"] == [{"seed": 1, "blue": 7}]
    assert [(one["seed"], one["message"]) for one in printed["failed"]] == [
        (2, "No space left on device"),
        (3, "No space left on device"),
    ]


def test_no_room_for_lines_of_progress_ends_no_matches(monkeypatch, capsys):
    """``simulate match 2> progress.txt``."""

    class Full(io.StringIO):
        def write(self, _):
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(sys, "stderr", Full())
    outcomes = [outcome(1, 7), outcome(2, 5)]
    monkeypatch.setattr(worker_pool, "run_all", lambda _, __, on_done: [on_done(one) or one for one in outcomes])
    assert run("simulate", "match", "--seeds", "1..2") == 0
    assert "2 matches" in capsys.readouterr().out
