"""Runs that are killed at random moments end with the tables and digests of one that nothing disturbed."""

import os
import random
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path

import pytest

from rcj_challenges.tournament.executor import LocalExecutor
from rcj_challenges.tournament.jobs import Workplace
from tests.tournament.store_helpers import Home

# One robot each, and one second: what is tested is what surrounds the matches.
DUEL = """
schema_version: 2
id: duel
title: Duel
extends: match
match: {half_s: 1, halves: 1, swap_sides: false}
entrants:
  blue: {robots: {B2: null, B3: null}}
  yellow: {robots: {Y2: null, Y3: null}}
"""
SHORT = """
tournament_version: 1
title: Short league
seed: 7
scenario: duel.yaml
teams_folder: teams
stages: {league: {stage: round_robin, legs: 2}}
"""
MATCH_S = 2.0

pytestmark = pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="finds processes by /proc")


def start(home):
    root = Path(__file__).parents[2]
    return subprocess.Popen([sys.executable, "-m", "tests.tournament.play_league", home.folder], cwd=root)


def new_home(folder):
    folder.mkdir(exist_ok=True)
    (folder / "duel.yaml").write_text(DUEL, encoding="utf-8")
    return Home(folder, SHORT, teams=("ada", "bee"))


def what_came_out(home):
    with home.opened(writing=False) as tournament:
        return home.tables(), {fixture: one["digest"] for fixture, one in tournament.store.summaries().items()}


def matches_of(runner):
    """Return the processes that a runner has started."""
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):
            if int(stat.read_text("utf-8", "replace").rpartition(")")[2].split()[1]) == runner.pid:
                found.append(int(stat.parent.name))
    return found


def kill_runner(runner, matches, chance):
    """Kill a run as a power cut does."""
    runner.kill()


def interrupt_runner(runner, matches, chance):
    """Interrupt a run by Ctrl-C; none of its matches goes on."""
    runner.send_signal(signal.SIGINT)
    runner.wait(60)
    assert not any(match in matches_of(runner) for match in matches)


def kill_match(runner, matches, chance):
    """Kill a match, and the run a little later, perhaps before the match is tried once more."""
    with suppress(ProcessLookupError):
        os.kill(chance.choice(matches), signal.SIGKILL)
    time.sleep(chance.uniform(0, 1.0))
    runner.kill()


KILLS = (kill_runner, kill_match, interrupt_runner)


def disturb(home, kills, chance):
    """Disturb a league so many times, each time at a random moment of a match."""
    for number in range(kills):
        with start(home) as runner:
            while runner.poll() is None and not (matches := matches_of(runner)):
                time.sleep(0.05)
            time.sleep(chance.uniform(0, MATCH_S))
            if runner.poll() is None:
                KILLS[number % len(KILLS)](runner, matches, chance)


def played_here(home):
    """Play a league without a disturbance; return what comes out."""
    home.play(executor=LocalExecutor(Workplace(home.data), 2))
    return what_came_out(home)


@pytest.mark.timeout(400)  # a busy computer is no failure
def test_a_league_that_is_disturbed_ends_as_one_that_is_not(tmp_path):
    disturbed = new_home(tmp_path / "disturbed")
    disturb(disturbed, 2, random.Random(4))  # noqa: S311 - which moments, reproducibly; interruptions: test_runner.py
    assert played_here(disturbed) == played_here(new_home(tmp_path / "undisturbed"))


@pytest.mark.nightly
@pytest.mark.timeout(3600)
def test_a_league_that_is_disturbed_thirty_times_ends_as_one_that_is_not(tmp_path):
    undisturbed = played_here(new_home(tmp_path / "undisturbed"))
    chance = random.Random(30)  # noqa: S311 - as above
    for number in range(10):
        disturbed = new_home(tmp_path / f"disturbed{number}")
        disturb(disturbed, 3, chance)
        assert played_here(disturbed) == undisturbed, f"league {number}"


@pytest.mark.nightly
def test_a_match_process_that_is_killed_costs_its_match_only_and_is_tried_once_more(tmp_path):
    home = new_home(tmp_path)
    with start(home) as runner:
        while runner.poll() is None and not (matches := matches_of(runner)):
            time.sleep(0.05)
        os.kill(matches[0], signal.SIGKILL)
        assert runner.wait(300) == 0
    assert len(home.state().outcomes) == 2
