"""What decides a challenge is shown after it was played: places, times, penalties and counters, not scores alone."""

import json
import re
from pathlib import Path

import pytest

from rcj_challenges.cli.commands import load_app
from rcj_challenges.cli.simulate import rank_summary
from rcj_challenges.match import worker_pool
from rcj_challenges.match.batch import Job, Outcome
from rcj_challenges.scenario.models.scenario import Result
from rcj_challenges.views.scoreboard import ranking_lines
from tests.cli.conftest import ONE_ROBOT, STAND
from tests.cli.in_this_process import played_one_after_the_other
from tests.scenario.writing import in_tuples

SLALOM = Path(__file__).resolve().parents[2] / "scenarios" / "examples" / "slalom.yaml"
NAMES = {"blue": "Hanse", "yellow": "Alster"}
BY_SCORE_THEN_COUNTER = [{"score": "each", "better": "more"}, {"counter": "fouls", "better": "less"}]
FOULS_AND_FALLS = {"sum": [{"counter": "fouls", "times": 3}, {"counter": "falls", "times": 5}]}
BY_TIME = [{"word": "time_s", "plus": FOULS_AND_FALLS, "better": "less"}]


def run(*arguments):
    return load_app()(list(map(str, arguments)), standalone_mode=False)


def criteria(rank):
    return Result.model_validate(in_tuples({"rank": rank})).rank


def placed(*entries):
    return [{"place": place, "team": team, "values": values} for place, team, values in entries]


def played(seed, *entries, ended="all gates passed"):
    return Outcome(Job(seed, ()), {"ranking": placed(*entries), "halves": [{"ended": ended}]})


@pytest.fixture
def still(tmp_path):
    """Return the options of two teams that stand still, for a short half; one robot of each has a program to do so."""
    team = tmp_path / "team.py"
    team.write_text(STAND, "utf-8")
    teams = ("--team", f"blue={team}", "--team", f"yellow={team}")
    return (*teams, *ONE_ROBOT, "--set", "match.half_s=0.5", "--set", "match.halves=1", "--out", tmp_path / "runs")


class TestLines:
    def test_equal_scores_are_distinguished_by_what_breaks_the_tie(self):
        ranking = placed((1, "yellow", [2, 1]), (2, "blue", [2, 3.5]))
        assert ranking_lines(criteria(BY_SCORE_THEN_COUNTER), NAMES, ranking) == [
            "place 1: Alster, score 2, fouls 1",
            "place 2: Hanse, score 2, fouls 3.5",
        ]

    def test_a_time_is_reported_to_the_tick_in_seconds_with_the_name_of_each_penalty_in_it(self):
        (line,) = ranking_lines(criteria(BY_TIME), NAMES, placed((1, "blue", [1209.248])))
        assert line == "place 1: Hanse, time 1209.248 s (with fouls, falls)"


class TestManyMatches:
    def test_places_are_counted_and_values_have_their_spread(self):
        outcomes = [
            played(1, (1, "yellow", [2, 1]), (2, "blue", [2, 3])),
            played(2, (1, "blue", [5, 2]), (2, "yellow", [2, 0])),
            played(3, (1, "blue", [4, 7]), (1, "yellow", [4, 7])),
        ]
        printed = rank_summary(criteria(BY_SCORE_THEN_COUNTER), outcomes)
        assert printed["criteria"] == ["score", "fouls"]
        assert printed["matches"][0] == {"seed": 1, "ranking": placed((1, "yellow", [2, 1]), (2, "blue", [2, 3]))}
        assert printed["places"] == {"yellow": {"1": 2, "2": 1}, "blue": {"1": 2, "2": 1}}
        assert printed["spread"]["blue"][1] == {"least": 2, "median": 3, "mean": 4.0, "most": 7}

    def test_matches_that_were_not_finished_come_last_in_the_spread_of_times(self):
        outcomes = [
            played(1, (1, "blue", [9.5])),
            played(2, (1, "blue", [5]), ended=None),  # its half was short
            played(3, (1, "blue", [12.5])),
            played(4, (1, "blue", [20]), ended=None),
            played(5, (1, "blue", [11])),
        ]
        (spread,) = rank_summary(criteria([{"word": "time_s", "better": "less"}]), outcomes)["spread"]["blue"]
        assert spread == {"least": 9.5, "median": 12.5, "mean": 11.0, "most": None, "unfinished": 2}


def test_a_run_that_time_decides_ends_with_places_and_times(tmp_path, capsys):
    assert run("run", SLALOM, "--quiet", "--no-replay", "--out", tmp_path) == 0
    score, place, *_ = capsys.readouterr().out.splitlines()
    assert score == "Slalom 4"
    assert re.fullmatch(r"place 1: Slalom, score 4, time \d+(\.\d+)? s \(with touched posts\)", place)


@pytest.fixture
def in_this_process(monkeypatch):
    """Let ``simulate`` play its matches here, each of which else is a second for what has to be loaded."""
    monkeypatch.setattr(worker_pool, "run_all", played_one_after_the_other)


@pytest.mark.usefixtures("in_this_process")
def test_simulate_shows_places_and_times_below_the_scores(tmp_path, capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    assert run("simulate", SLALOM, "--seeds", "1,2", "--quiet", "--out", tmp_path) == 0
    lines = [line for line in capsys.readouterr().out.splitlines() if "┃" in line or "│" in line]
    scores, row, decides, decided = (re.split(r"\s*[┃│]\s*", line)[1:-1] for line in lines)
    assert (scores, row) == (["entrant", "least", "median", "mean", "most"], ["yellow", "4", "4", "4", "4"])
    assert decides == ["entrant", "place 1", "time (s) (with touched posts)"]
    assert decided[:2] == ["yellow", "2 times"]
    assert re.fullmatch(r"[\d.]+|[\d.]+ to [\d.]+, median [\d.]+", decided[2])


@pytest.mark.usefixtures("in_this_process")
def test_json_of_simulate_holds_what_was_compared(tmp_path, capsys, still):
    rank = "result.rank=[{score: each, better: more}, {sum: {counter: put_backs, entity: each}, better: less, says: P}]"
    assert run("simulate", "match", "--seeds", "1", "--set", rank, *still, "--json") == 0
    printed = json.loads(capsys.readouterr().out)["ranking"]
    assert printed["criteria"] == ["score", "put_backs"]
    assert printed["matches"] == [{"seed": 1, "ranking": placed((1, "blue", [0, 0]), (1, "yellow", [0, 0]))}]
