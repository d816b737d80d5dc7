"""The same attempts by programs of a user without any privileges, for those who run the other tests as root."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import pytest

NOBODY = 65534
HERE = Path(__file__).parent
IMPORTED_FROM = os.pathsep.join([str(HERE.parents[1]), str(Path(np.__file__).parents[1])])


def run_as_nobody(python: str, folder: Path, *arguments: str) -> subprocess.CompletedProcess[str]:
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
        timeout=120,
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


@pytest.mark.skipif(sys.platform != "linux", reason="layers of Linux")
@pytest.mark.skipif(sys.platform == "linux" and os.geteuid() != 0, reason="the other tests run without privileges here")
def test_isolation_holds_for_a_user_without_privileges(python: str) -> None:
    chosen = [str(HERE / "test_isolation.py"), "-k", "not plays_the_same and not threaded"]
    settings = ["-n", "0", "-p", "no:cacheprovider", "-c", str(HERE.parents[1] / "pyproject.toml")]
    with tempfile.TemporaryDirectory() as folder:  # pytest keeps others out of its own
        os.chown(folder, NOBODY, NOBODY)
        ran = run_as_nobody(python, Path(folder), "-m", "pytest", *settings, *chosen)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert ran.stdout.count(".") > 80, ran.stdout
