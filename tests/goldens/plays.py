"""What the golden files hold: which matches are played with which frozen teams, and on what kind of machine."""

import hashlib
import json
import platform
from dataclasses import dataclass
from pathlib import Path

from rcj_challenges.expect.runner import run_test
from rcj_challenges.match.runner import MatchPlan, play_match
from rcj_challenges.records.result import versions
from rcj_challenges.scenario.load import load
from rcj_challenges.submissions.team import open_team

FOLDER = Path(__file__).parent
STATES = FOLDER / "states.json"
TESTS = FOLDER / "expect.json"
RECORD = FOLDER / "record"
SCENARIOS = Path(__file__).parents[2] / "scenarios"
SHORT = ("match.halves=1", "match.half_s=8")


@dataclass(frozen=True)
class Play:
    """A scenario with a frozen team for each entrant, from ``teams``; ``lengths``: what is compared of it."""

    scenario: str
    teams: dict[str, str]
    lengths: tuple[str, ...] = ("short", "whole")


PLAYS = (
    Play("match", {"blue": "roles_and_radio", "yellow": "all_sensors"}),
    Play("match_2021", {"blue": "match_2021", "yellow": "match_2021"}, ("short",)),
    Play("fast_shooter", {"yellow": "fast_shooter"}),
    Play("pass_the_ball", {"yellow": "pass_the_ball"}),
    Play("precision_lidar", {"yellow": "precision_lidar"}),
    Play("examples/colour_hunt", {"yellow": "colour_hunt"}),
    Play("examples/hot_spot", {"blue": "hot_spot", "yellow": "hot_spot"}),
    Play("examples/keeper", {"yellow": "keeper"}),
    Play("examples/market", {"yellow": "market"}),
    Play("examples/search", {"yellow": "search"}),
    Play("examples/slalom", {"yellow": "slalom"}),
    Play("variants/fast_shooter_v2", {"yellow": "chaser_v2"}),
    Play("variants/pass_the_ball_v2", {"yellow": "chaser_v2"}),
    Play("variants/precision_lidar_v2", {"yellow": "chaser_v2"}),
)


def machine() -> str:
    """Return on what states depend beside the inputs: results compare only where this is the same.

    The C library counts, because programs and noise take sines and logarithms from it; the version of Python does not.
    """
    made = versions()
    libc = " ".join(platform.libc_ver()).strip()
    parts = (made.system, made.machine, libc, made.python.split()[0], f"mujoco {made.mujoco}", f"numpy {made.numpy}")
    return ", ".join(part for part in parts if part)


def played(play: Play, length: str, out: Path) -> dict:
    """Play it and return the part of its result that is compared."""
    loaded = load(SCENARIOS / f"{play.scenario}.yaml", [] if length == "whole" else SHORT)
    seats = loaded.scenario.entrants
    swaps = loaded.scenario.match.swap_sides
    teams = {}
    for seat in seats:
        path = FOLDER / "teams" / f"{play.teams[seat]}.zip"
        teams[seat] = open_team(path, *(seats.values() if swaps else (seats[seat],)))
    result = play_match(MatchPlan(loaded, teams, {}, out=out, sandbox="off")).result
    assert result["faults"] == []
    return {"score": result["score"], "events": len(result["events"]), "states": result["states"]}


def judged_tests(name: str) -> dict:
    """Return what comes of all tests in a scenario file: how many there are, and a hash over ticks and fired rules."""
    loaded = load(SCENARIOS / f"{name}.yaml")
    trials = {test: run_test(loaded, test) for test in loaded.scenario.expect}
    assert {test: trial.differences for test, trial in trials.items() if trial.differences} == {}
    data = [[test, trial.ticks, trial.fired] for test, trial in trials.items()]
    return {"tests": len(data), "hash": hashlib.sha256(json.dumps(data).encode()).hexdigest()}


def read(path: Path) -> dict:
    return json.loads(path.read_text("utf-8"))
