"""Real short matches: real processes, real physics, the shipped match with a few numbers changed."""

import json
from dataclasses import dataclass, replace
from itertools import count
from pathlib import Path

from rcj_challenges.core.traffic import Request
from rcj_challenges.expect.scripted_match import half_of
from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.match.stage import build_stage
from rcj_challenges.records.trajectory import Trajectory
from rcj_challenges.scenario.load import load, load_text
from rcj_challenges.submissions.team import open_team
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


class Place:
    """A folder for teams and records."""

    def __init__(self, folder):
        self.folder = folder
        self._made = count()

    def team_folder(self, *programs, name="Testers"):
        """Write a team whose robots 1, 2, 3 run these programs (one for all, if only one is given)."""
        folder = self.folder / f"team{next(self._made)}"
        for number in (1, 2, 3):
            entry = folder / f"robot{number}" / f"robot{number}.py"
            entry.parent.mkdir(parents=True)
            entry.write_text(programs[min(number, len(programs)) - 1], encoding="utf-8")
        (folder / "team_name.txt").write_text(name, encoding="utf-8")
        return folder

    def play(self, *overrides, blue=None, yellow=None, seed=1, scenario="match", observer=None, **plan):
        """Play a short match: one half of a few seconds unless the overrides say otherwise.

        The scenario is a name or the whole text of one.
        A team that is not given stands still: its first robot runs a program that says so, the others have none, which
        comes to the same and starts fewer processes. (Where teams change sides both have all theirs.)
        """
        given = {"blue": blue or self.team_folder(STAND), "yellow": yellow or self.team_folder(STAND)}
        idle = [seat for seat, team in (("blue", blue), ("yellow", yellow)) if team is None]
        stand = alone(*idle)
        if len(idle) == 1:
            changing = any(override.startswith("match.halves=") for override in overrides)
            stand = [] if changing else ["match.swap_sides=false", *stand]
        given_as = load_text if "\n" in scenario else load
        loaded = given_as(scenario, ["match.halves=1", "match.half_s=5", *stand, *overrides])
        seats = tuple(loaded.scenario.entrants.values())
        teams = {seat: open_team(given[seat], *seats) for seat in loaded.scenario.entrants}
        outcome = play_match(MatchPlan(loaded, teams, {}, seed=seed, out=self.folder / "runs", **plan), observer)
        return Run(outcome.folder, outcome.result)


def alone(*seats):
    """Return the overrides by which only the first robot of these seats has a program; the others stand still."""
    return [f"entrants.{seat}.robots.{seat[0].upper()}{number}=null" for seat in seats for number in (2, 3)]


class StandIn:
    """A program in place of one in a process of its own: it asks for steps of so many ticks."""

    def __init__(self, ticks=1):
        self.ticks = ticks

    def collect(self):
        return Request(self.ticks)

    def collect_soon(self):
        return self.collect()

    def release(self, observation):
        pass

    def limit_fault(self, tick):
        return None


def staged(ticks, program):
    """Return a half of so many ticks and its stage; the function gives each robot, by name, a program."""
    loaded = load("match")
    half = replace(half_of(loaded.scenario), ticks=ticks)
    drivers = {index: program(name) for index, name in enumerate(loaded.roster.entities[: loaded.roster.robots])}
    return half, build_stage(loaded.scenario, loaded.roster, half, drivers)
