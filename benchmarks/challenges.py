"""The bars of the challenges: two minutes with their champions, checking and testing scenarios, the lidar.

    python -m benchmarks.challenges [--json] [--rounds 3]

Medians over the rounds. A challenge's time is that of the play after start-up: from the moment at which all programs
have called ``step`` to the closed record. (`python -m benchmarks` measures the start by itself.)
"""

from __future__ import annotations

import json
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from functools import partial
from typing import Any

from benchmarks import sensing_cost
from benchmarks.rows import Row, as_users_have_it, parser, show
from rcj_challenges.scenario.load import load

CHALLENGES = {"fast_shooter": 2.0, "precision_lidar": 2.0, "pass_the_ball": 3.0}
"""And how many seconds two minutes of each may take: with one program, or with four."""


def command(*arguments: str) -> tuple[float, str]:
    """Run a command; returns how long it took in s, and what it printed."""
    began = time.perf_counter()
    done = subprocess.run(
        [sys.executable, "-m", "rcj_challenges", *arguments],
        check=True, capture_output=True, text=True, env=as_users_have_it(),
    )  # fmt: skip
    return time.perf_counter() - began, done.stdout


def play_s(challenge: str, out: str) -> float:
    """Return how long a play of a challenge took after its start-up, in s."""
    _, printed = command("run", challenge, "--json", "--no-replay", "--out", out)
    result: dict[str, Any] = json.loads(printed)
    return float(result["wall_s"]) - float(result["start_up_s"])


def rows(rounds: int) -> list[Row]:
    """Measure everything."""

    def median(measure: Callable[[], float]) -> float:
        measure()  # writes byte code
        return round(statistics.median(measure() for _ in range(rounds)), 2)

    made = []
    with tempfile.TemporaryDirectory() as out:
        for challenge, must_s in CHALLENGES.items():
            made.append(Row(f"{challenge}, its champion", median(partial(play_s, challenge, out)), "s", must_s))
    made.append(Row("validate", median(lambda: command("validate", "match")[0]), "s", 0.5))
    made.append(Row("test of the four", median(lambda: command("test", "match", *CHALLENGES)[0]), "s", 5.0))
    lidar = load("precision_lidar")
    whole = median(lambda: sensing_cost.measure(lidar, 2000)["median_us"])
    made.append(Row("sensing with a lidar, one robot", whole, "us/tick", 150.0))
    return made


def main() -> int:
    """Print the table; exit code 1 if a must is missed."""
    options = parser("the bars of the challenges, measured")
    options.add_argument("--rounds", type=int, default=3)
    given = options.parse_args()
    return show(rows(given.rounds), as_json=given.json)


if __name__ == "__main__":
    sys.exit(main())
