"""Real short matches: real processes, real physics, the shipped match with a few numbers changed."""

import json
from dataclasses import dataclass
from pathlib import Path

import pytest

from rcj_challenges.controllers.team import open_team
from rcj_challenges.match.match import MatchPlan, play_match
from rcj_challenges.records.trajectory import Trajectory
from rcj_challenges.scenario.load import load
from tests.match.programs import STAND


@dataclass(frozen=True)
class Run:
    """A played match, read back from its record."""

    folder: Path
    result: dict

    @property
    def reflog(self):
        return [json.loads(line) for line in (self.folder / "reflog.jsonl").read_text("utf-8").splitlines()]

    def events(self, name):
        return [line for line in self.reflog if line["event"] == name]

    @property
    def trajectory(self):
        return Trajectory.open(self.folder)

    def log(self, robot):
        return (self.folder / "logs" / f"{robot}.log").read_text("utf-8")


@pytest.fixture
def team_folder(tmp_path):
    """Write a team whose robots 1, 2, 3 run these programs (one for all, if only one is given)."""
    made = iter(range(100))

    def write(*programs, name="Testers"):
        folder = tmp_path / f"team{next(made)}"
        for number in (1, 2, 3):
            entry = folder / f"robot{number}" / f"robot{number}.py"
            entry.parent.mkdir(parents=True)
            entry.write_text(programs[min(number, len(programs)) - 1], encoding="utf-8")
        (folder / "team_name.txt").write_text(name, encoding="utf-8")
        return folder

    return write


@pytest.fixture
def play(tmp_path, team_folder):
    """Play a short match: one half of a few seconds unless the overrides say otherwise."""

    def run(*overrides, blue=None, yellow=None, seed=1, scenario="match", watcher=None, **plan):
        loaded = load(scenario, ["match.halves=1", "match.half_s=5", *overrides])
        given = {"blue": blue or team_folder(STAND), "yellow": yellow or team_folder(STAND)}
        seats = tuple(loaded.scenario.entrants.values())
        teams = {seat: open_team(given[seat], *seats) for seat in loaded.scenario.entrants}
        outcome = play_match(MatchPlan(loaded, teams, {}, seed=seed, out=tmp_path / "runs", **plan), watcher)
        return Run(outcome.folder, outcome.result)

    return run
