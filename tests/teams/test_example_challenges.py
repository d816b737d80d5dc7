"""The sample programs of the example challenges show that those can be played."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from rcj_challenges.cli.commands import load_app
from tests.teams.test_workshop import AT_RANDOM

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def play(tmp_path):
    """Return a function that plays an example challenge with its sample team and returns the result."""

    def run(name: str, *options: str) -> dict:
        scenario = ROOT / "scenarios" / "examples" / f"{name}.yaml"
        out = ("--out", str(tmp_path), "--json", "--no-replay")
        done = CliRunner().invoke(load_app(), ["run", str(scenario), *out, *options])
        assert done.exit_code == 0, done.exception
        return json.loads(done.stdout)

    return run


def test_the_slalom_is_driven_through_all_four_gates(play):
    result = play("slalom")
    assert result["faults"] == []
    assert result["score"] == {"yellow": 4}
    assert result["simulated_s"] < 15


def test_the_crate_is_found_and_reported_by_radio(play):
    result = play("search", "--duration", "30")
    assert result["faults"] == []
    assert result["score"]["yellow"] >= 9


def test_a_ball_that_is_wanted_is_sold_on_the_market(play):
    result = play("market", "--duration", "25", "--set", "order_s=20")
    assert result["faults"] == []
    assert result["score"]["yellow"] >= 2


def test_both_teams_know_where_it_is_hot(play):
    result = play("hot_spot", "--duration", "10", "--halves", "1", "--set", "hot_for_s=5", "--set", "camping_s=5")
    assert result["faults"] == []
    assert set(result["score"]) == {"blue", "yellow"}


def test_the_keeper_stops_more_than_it_lets_in(play):
    team = str(ROOT / "examples" / "teams" / "keeper")
    result = play("keeper", "--yellow", team, "--set", "shots=8")
    assert result["faults"] == []
    assert 5 <= result["score"]["yellow"] <= 16


HUNTERS = ("colour_hunt", "colour_hunt_recognition")


@pytest.mark.parametrize("name", HUNTERS)
def test_balls_are_found_by_their_colour(play, name):
    result = play("colour_hunt", "--duration", "15", "--yellow", str(ROOT / "examples" / "teams" / name))
    assert result["faults"] == []
    assert result["score"]["yellow"] >= 5


@pytest.mark.parametrize("name", HUNTERS)
def test_the_programs_of_the_colour_hunt_are_short(name):
    lines = (ROOT / "examples" / "teams" / name / "robot.py").read_text(encoding="utf-8").splitlines()
    assert len(lines) <= 80
    assert max(map(len, lines)) <= 120


@pytest.mark.nightly
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("name", HUNTERS)
def test_in_two_minutes_at_least_eight_balls_are_found(play, name):
    team = ("--yellow", str(ROOT / "examples" / "teams" / name))
    results = [play("colour_hunt", *team, "--seed", str(seed)) for seed in range(1, 11)]
    # A found ball gives 3 points, and other balls cost some: at least a third of the points were found.
    found = [result["score"]["yellow"] / 3 for result in results]
    assert sum(found) / len(found) >= 8, found
    assert min(found) >= 4, found


@pytest.mark.nightly
@pytest.mark.timeout(1800)
def test_a_driver_at_random_scores_about_nothing_in_the_colour_hunt(play, tmp_path):
    (tmp_path / "team").mkdir()
    (tmp_path / "team" / "robot.py").write_text(AT_RANDOM, encoding="utf-8")
    results = [play("colour_hunt", "--yellow", str(tmp_path / "team"), "--seed", str(seed)) for seed in range(1, 11)]
    points = [result["score"]["yellow"] for result in results]
    assert abs(sum(points)) / len(points) <= 3, points
