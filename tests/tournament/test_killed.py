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

from tests.tournament.store_helpers import LEAGUE, Home

# One robot each, and one second: what is tested is what surrounds the matches.
SHORT = LEAGUE.replace(
    "{match.half_s: 2, match.halves: 1}",
    "{match.half_s: 1, match.halves: 1, match.swap_sides: false, entrants.blue.robots.B2: null, "
    "entrants.blue.robots.B3: null, entrants.yellow.robots.Y2: null, entrants.yellow.robots.Y3: null}",
)
RUN_S = 6.0

pytestmark = pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="finds processes by /proc")


def start(home):
    root = Path(__file__).parents[2]
    return subprocess.Popen([sys.executable, "-m", "tests.tournament.play_league", home.folder], cwd=root)


def played_league(folder):
    home = Home(folder, SHORT)
    with start(home) as runner:
        assert runner.wait(300) == 0
    return home


def what_came_out(home):
    with home.opened(writing=False) as tournament:
        return home.tables(), tournament.store.digests()


def matches_of(runner):
    """Return the processes that a runner has started."""
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):
            if int(stat.read_text().rpartition(")")[2].split()[1]) == runner.pid:
                found.append(int(stat.parent.name))
    return found


def first_matches_of(runner):
    """Wait until a runner has started a match."""
    while runner.poll() is None:
        if matches := matches_of(runner):
            return matches
        time.sleep(0.05)
    raise AssertionError("it has ended without a match")


def disturb(home, kills, chance):
    """Run the league, kill the runner or one of its matches so many times, and let it come to its end."""
    for number in range(kills):
        with start(home) as runner:
            until = time.monotonic() + chance.uniform(0.5, RUN_S)
            while time.monotonic() < until and runner.poll() is None:
                time.sleep(0.05)
            matches = matches_of(runner)
            if number % 2 and matches and runner.poll() is None:
                with suppress(ProcessLookupError):
                    os.kill(chance.choice(matches), signal.SIGKILL)
                time.sleep(chance.uniform(0, 0.5))
            runner.kill()
    with start(home) as runner:
        assert runner.wait(300) == 0


def test_a_league_that_is_killed_twice_ends_as_one_that_is_not(tmp_path):
    undisturbed, disturbed = played_league(tmp_path / "undisturbed"), Home(tmp_path / "disturbed", SHORT)
    disturb(disturbed, 2, random.Random(4))  # noqa: S311 - which moments, reproducibly
    assert what_came_out(disturbed) == what_came_out(undisturbed)


def test_a_match_process_that_is_killed_costs_its_match_only_and_is_tried_once_more(tmp_path):
    home = Home(tmp_path, SHORT)
    with start(home) as runner:
        matches = first_matches_of(runner)
        os.kill(matches[0], signal.SIGKILL)
        assert runner.wait(300) == 0
    assert len(home.state().outcomes) == 4


def test_ctrl_c_leaves_no_process_and_the_run_goes_on_later(tmp_path):
    home = Home(tmp_path, SHORT)
    with start(home) as runner:
        matches = first_matches_of(runner)
        runner.send_signal(signal.SIGINT)
        assert runner.wait(60) != 0
    assert not any(Path(f"/proc/{match}").exists() for match in matches)
    with start(home) as runner:
        assert runner.wait(300) == 0
    assert len(home.state().outcomes) == 4


@pytest.mark.nightly
@pytest.mark.timeout(1800)
def test_a_league_that_is_killed_thirty_times_ends_as_one_that_is_not(tmp_path):
    undisturbed, disturbed = played_league(tmp_path / "undisturbed"), Home(tmp_path / "disturbed", SHORT)
    chance = random.Random(30)  # noqa: S311 - as above
    for round_ in range(10):
        disturb(disturbed, 3, chance)
        assert what_came_out(disturbed) == what_came_out(undisturbed), f"round {round_}"
        if round_ % 3 == 2:  # from the beginning once more
            disturbed = Home(tmp_path / f"disturbed{round_}", SHORT)
