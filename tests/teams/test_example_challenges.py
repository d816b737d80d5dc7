"""The sample programs of the example challenges show that those can be played."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from rcj_challenges.cli.commands import app

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def play(tmp_path):
    """Return a function that plays an example challenge with its sample team and returns the result."""

    def run(name: str, *options: str) -> dict:
        scenario = ROOT / "scenarios" / "examples" / f"{name}.yaml"
        out = ("--out", str(tmp_path), "--json", "--no-replay")
        done = CliRunner().invoke(app, ["run", str(scenario), *out, *options])
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
