"""Plays the league of a folder with real matches, in a process of its own that a test can kill."""

import sys
from pathlib import Path

from rcj_challenges.tournament.executor import LocalExecutor
from rcj_challenges.tournament.jobs import Workplace
from tests.tournament.store_helpers import Home

if __name__ == "__main__":
    home = Home(Path(sys.argv[1]))
    home.play(executor=LocalExecutor(Workplace(home.data), 2))
