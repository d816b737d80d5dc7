"""The check that floats of a match are added in one way."""

from __future__ import annotations

import runpy
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[2] / "scripts" / "check_float_sums.py"


def complaints(tmp_path: Path, source: str, folder: str = "world") -> int:
    package = tmp_path / "rcj_challenges"
    for name in runpy.run_path(str(SCRIPT))["DECIDING"]:
        path = package / name
        (path.parent if path.suffix else path).mkdir(parents=True, exist_ok=True)
    (package / "scenario" / "outlines.py").touch()
    (package / folder).mkdir(exist_ok=True)
    (package / folder / "module.py").write_text(source, encoding="utf-8")
    done = subprocess.run([sys.executable, str(SCRIPT), str(tmp_path)], capture_output=True, text=True, check=False)
    return done.returncode


@pytest.mark.parametrize(
    "source",
    [
        "total = sum(values)",
        "add = sum",
        "import math\ntotal = math.fsum(values)",
        "from math import fsum as add",
        "import math\nlength = math.dist(a, b)",
        "import statistics as s",
        "from statistics import median",
        "import numpy as np\ntotal = np.sum(values)",
        "total = values.mean()",
    ],
)
def test_helpers_that_add_in_their_own_way_are_refused(tmp_path, source):
    assert complaints(tmp_path, source) == 1


@pytest.mark.parametrize(
    "source", ["total = add_up(values)", "count = sum(map(len, values))  # integers", "x = touch.dist"]
)
def test_plain_additions_and_sums_of_whole_numbers_are_allowed(tmp_path, source):
    assert complaints(tmp_path, source) == 0


def test_pages_and_statistics_may_add_as_they_like(tmp_path):
    assert complaints(tmp_path, "total = sum(values)", folder="views") == 0
