"""The sample keeper stops shots, and the shots are worth stopping."""

from __future__ import annotations

import json
from pathlib import Path

from typer.testing import CliRunner

from rcj_challenges.cli.app import app

ROOT = Path(__file__).resolve().parents[2]


def test_the_keeper_stops_more_than_it_lets_in(tmp_path):
    scenario = ROOT / "scenarios" / "examples" / "keeper.yaml"
    out = ("--out", str(tmp_path), "--json", "--no-replay", "--set", "shots=8")
    team = str(ROOT / "examples" / "teams" / "keeper")
    done = CliRunner().invoke(app, ["run", str(scenario), "--yellow", team, *out])
    assert done.exit_code == 0, done.exception
    result = json.loads(done.stdout)
    assert result["faults"] == []
    assert 5 <= result["score"]["yellow"] <= 16
