"""The bars of the match in one table: what it costs, as ratios to the raw physics of the same model in the same run.

    python -m benchmarks [--json] [--quick] [--same]

``--same`` adds the long test of repeatability: ten halves in a row, one pinned to one core, one beside another match,
all with one digest. ``--quick`` plays halves of 60 s (ratios only; the absolute bars need whole halves).
``python -m benchmarks.challenges`` and ``python -m benchmarks.watching`` measure the rest.
"""

from __future__ import annotations

import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from benchmarks import physics_floor, referee_cost, sensing_cost
from benchmarks.rows import Row, as_users_have_it, parser, show
from rcj_challenges.core.timing import TICK_S
from rcj_challenges.scenario.load import load
from rcj_challenges.world.world import World

PROGRAM = Path(__file__).parent / "programs" / "trivial" / "robot.py"
HALF_S = 600.0


def half(out: Path, half_s: float, *more: str, prefix: Sequence[str] = (), seed: int = 1) -> subprocess.Popen[str]:
    """Start a half with six trivial programs in a process of its own; it prints its result as JSON."""
    command = [*prefix, sys.executable, "-m", "rcj_challenges", "run", "match", "--halves", "1", "--json"]
    command += ["--no-replay", "--duration", f"{half_s:g}", "--seed", str(seed), "--out", str(out)]
    command += ["--blue", str(PROGRAM), "--yellow", str(PROGRAM), *more]
    return subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=as_users_have_it())


def result(process: subprocess.Popen[str]) -> dict[str, Any]:
    """Wait for a half and return its result."""
    out, _ = process.communicate()
    assert process.returncode == 0, process.returncode
    told: dict[str, Any] = json.loads(out)
    return told


def peak_memory_mb(process: subprocess.Popen[str]) -> float:
    """Return the largest resident size of a running process until it ends, in MB (Linux)."""
    peak = 0.0
    status = Path(f"/proc/{process.pid}/status")
    while process.poll() is None:
        try:
            line = next(line for line in status.read_text(encoding="utf-8").splitlines() if line.startswith("VmHWM"))
        except (OSError, StopIteration):
            break
        peak = int(line.split()[1]) / 1000
        time.sleep(0.2)
    return peak


def speed_rows(out: Path, half_s: float) -> list[Row]:
    """Measure the floor, then whole halves, then the floor again, so that the ratio is of the same minutes."""
    loaded = load("match")

    def floor_us() -> float:
        return physics_floor.measure(lambda: World(loaded.scenario, loaded.roster), min(half_s, 60.0))[
            "physics_us_per_tick"
        ]

    floors, walls = [floor_us()], []
    for seed in (1, 2, 3):
        told = result(half(out, half_s, seed=seed))
        walls.append(told["wall_s"] - told["start_up_s"])  # the start has a row of its own
        floors.append(floor_us())
    floor, wall = statistics.median(floors), statistics.median(walls)
    began = time.perf_counter()
    result(half(out, TICK_S))
    start_s = time.perf_counter() - began
    began = time.perf_counter()
    for process in [half(out, half_s, seed=seed) for seed in (1, 2)]:
        result(process)
    pair_s = time.perf_counter() - began
    process = half(out, half_s)
    peak = peak_memory_mb(process) if sys.platform == "linux" else 0.0
    result(process)
    whole = half_s >= HALF_S
    floor_s = floor * half_s / TICK_S / 1e6
    return [
        Row("half, six programs, over the floor", round(wall / floor_s, 2), "x", 2.2, 1.6),
        Row("half, six programs", round(wall, 3), "s", 10.0 if whole else None, 6.5),
        Row("physics, the floor", floor, "us/tick", 260.0, 150.0),
        Row("start, one tick, end", round(start_s, 2), "s", 1.0, 0.5),
        Row("two matches at once", round(2 * 3600 / pair_s), "halves/h", 700 if whole else None, 1000, True),
        Row("memory of the match's process", round(peak), "MB", 300.0, None),
    ]


def part_rows() -> list[Row]:
    """Measure sensing and referee by themselves."""
    loaded = load("match")
    referee = min(referee_cost.measure(loaded, 18_750, seed)["mean_us"] for seed in (1, 2))
    sensing = sensing_cost.measure(loaded, ticks=4000)
    return [
        Row("sensing, six robots", round(sensing["median_us"], 1), "us/tick", 60.0, 25.0),
        Row("referee of the match", round(referee, 1), "us/tick", 40.0, 15.0),
    ]


def same_rows(out: Path, half_s: float) -> list[Row]:
    """Play the same half again and again, under different conditions, and count the digests."""
    digests = [result(half(out, half_s))["digest"] for _ in range(10)]
    if hasattr(os, "sched_setaffinity"):
        digests.append(result(half(out, half_s, prefix=["taskset", "-c", "0"]))["digest"])
    beside, other = half(out, half_s), half(out, half_s, seed=2)
    digests.append(result(beside)["digest"])
    result(other)
    return [Row(f"different digests of {len(digests)} equal halves", len(set(digests)), "", 1, 1)]


def main() -> int:
    """Print the table; exit code 1 if a must is missed."""
    options = parser("the bars of the match, measured")
    options.add_argument("--quick", action="store_true", help="halves of 60 s")
    options.add_argument("--same", action="store_true", help="also the test of repeatability")
    given = options.parse_args()
    half_s = 60.0 if given.quick else HALF_S
    with tempfile.TemporaryDirectory() as out:
        rows = [*speed_rows(Path(out), half_s), *part_rows()]
        if given.same:
            rows += same_rows(Path(out), half_s)
    return show(rows, as_json=given.json)


if __name__ == "__main__":
    sys.exit(main())
