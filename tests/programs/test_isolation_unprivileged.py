"""The same attempts by programs of a user without any privileges, for those who run the other tests as root."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

NOBODY = 65534
HERE = Path(__file__).parent
IMPORTED_FROM = os.pathsep.join([str(HERE.parents[1]), str(Path(np.__file__).parents[1])])


def run_as_nobody(
    python: str, folder: Path, *arguments: str, timeout_s: float = 120
) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [python, *arguments],
        user=NOBODY,
        group=NOBODY,
        extra_groups=[],
        cwd="/",
        env={
            "PATH": os.defpath,
            "HOME": str(folder),
            "TMPDIR": str(folder),
            "PYTHONPATH": IMPORTED_FROM,
            "PYTHONDONTWRITEBYTECODE": "1",
        },
        capture_output=True,
        text=True,
        timeout=timeout_s,
        check=False,
    )


@pytest.fixture
def python(tmp_path: Path) -> str:
    """A Python of this version that everybody may start, where the tests' own is in a folder of root's."""
    version = f"python3.{sys.version_info.minor}"
    candidates = [sys.executable, shutil.which(version, path=os.defpath), f"/usr/local/bin/{version}"]
    for candidate in candidates:
        try:
            tried = run_as_nobody(candidate or "", tmp_path, "-c", "import numpy, pydantic, pytest, rcj_challenges")
        except OSError:
            continue
        if tried.returncode == 0:
            return str(candidate)
    pytest.skip(f"there is no {version} here that a user without privileges may start and that finds the packages")


@pytest.fixture
def folder() -> Iterator[Path]:
    """A temporary folder of that user; pytest keeps others out of its own."""
    with tempfile.TemporaryDirectory() as made:
        os.chown(made, NOBODY, NOBODY)
        yield Path(made)


needs_root = pytest.mark.skipif(
    sys.platform != "linux" or os.geteuid() != 0, reason="layers of Linux; other tests run without privileges already"
)
SETTINGS = ["-n", "0", "-p", "no:cacheprovider", "-c", str(HERE.parents[1] / "pyproject.toml")]


@needs_root
def test_isolation_holds_for_a_user_without_privileges(python: str, folder: Path) -> None:
    chosen = [str(HERE / "test_isolation.py"), "-k", "not plays_the_same and not threaded"]
    ran = run_as_nobody(python, folder, "-m", "pytest", *SETTINGS, *chosen)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert ran.stdout.count(".") > 80, ran.stdout


@pytest.mark.nightly
@needs_root
def test_hostile_programs_are_held_for_a_user_without_privileges_with_and_without_bubblewrap(
    python: str, folder: Path
) -> None:
    chosen = [str(HERE.parent / "hostile" / "test_programs.py"), "-k", "costs_its_own_robot or without_bubblewrap"]
    all_ = ["-m", "nightly or not nightly"]
    ran = run_as_nobody(python, folder, "-m", "pytest", *SETTINGS, *chosen, *all_, timeout_s=1500)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert ran.stdout.count(".") > 60, ran.stdout
