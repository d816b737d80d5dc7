"""Every benchmark still runs, in its smallest form, and measures something: their figures are compared by people."""

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]
SMALLEST = {
    "exchange": ["--ticks", "50", "--rounds", "1", "--json"],
    "physics_floor": ["1"],
    "sensing_cost": ["--ticks", "50"],
    "referee_cost": ["--ticks", "100", "--repeats", "1", "--json"],
    "omni_cost": ["--pairs", "2", "--ticks", "10", "--json"],
    "inputs": ["zones", "--json"],
    "club": ["--minutes", "0.5", "--teams", "4", "--half-s", "2", "--json"],
    "challenges": ["--rounds", "1", "--json"],
    "watching": ["--rounds", "1", "--json"],
    "tournament": ["--quick", "--json"],
    "stage": ["--spectators", "3", "--rounds", "1", "--window-s", "6", "--teams", "3", "--half-s", "4", "--json"],
    "__main__": ["--quick", "--json"],
}
"""How each is started; the last six measure no less than what their bars are about."""
WITH_BARS = {"challenges", "club", "watching", "tournament", "stage", "__main__"}
NO_BENCHMARKS = {"__init__", "rows"}


def measured(name: str) -> Any:
    """Return what a benchmark prints. A bar that is missed, on whatever machine this is, does not concern this test."""
    if name == "watching" and sys.platform != "linux":
        pytest.skip("its films are drawn without a screen, which is sure to work on Linux only")
    module = "benchmarks" if name == "__main__" else f"benchmarks.{name}"
    done = subprocess.run(
        [sys.executable, "-m", module, *SMALLEST[name]],
        cwd=ROOT, env=dict(os.environ), capture_output=True, encoding="utf-8", timeout=900, check=False,
    )  # fmt: skip
    assert done.returncode in ((0, 1) if name in WITH_BARS else (0,)), done.stderr
    assert "Traceback" not in done.stderr, done.stderr
    return json.loads(done.stdout)


def numbers(reported: Any) -> list[float]:
    """Return all numbers of what was printed."""
    if isinstance(reported, dict):
        return [number for value in reported.values() for number in numbers(value)]
    return [float(reported)] if isinstance(reported, (int, float)) else []


def test_each_benchmark_is_tried() -> None:
    assert {path.stem for path in (ROOT / "benchmarks").glob("*.py")} - NO_BENCHMARKS == SMALLEST.keys()


@pytest.mark.nightly
@pytest.mark.parametrize("name", sorted(SMALLEST.keys() - WITH_BARS))
def test_a_benchmark_of_a_part_prints_its_figures(name: str) -> None:
    reported = measured(name)
    assert reported
    assert max(numbers(reported)) > 0


@pytest.mark.nightly
@pytest.mark.parametrize("name", sorted(WITH_BARS))
def test_a_table_of_bars_has_a_figure_in_each_row(name: str) -> None:
    rows = measured(name)
    assert len(rows) >= 5
    for row in rows:
        assert row["what"]
        assert isinstance(row["measured"], (int, float))
