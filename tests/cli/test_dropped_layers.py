"""A layer of isolation that cannot be used is named on the terminal, in the record and in the report."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from rcj_challenges.programs import isolation

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="layers of Linux")

RUN = ("run", "match", "--halves", "1", "--duration", "0.1", "--no-replay")


@pytest.fixture
def broken(tmp_path: Path) -> dict[str, str]:
    """An environment with a bubblewrap that may not make name spaces."""
    bwrap = tmp_path / "bin" / "bwrap"
    bwrap.parent.mkdir()
    bwrap.write_text("#!/bin/sh\necho no name spaces >&2\nexit 1\n", encoding="utf-8")
    bwrap.chmod(0o755)
    return {**os.environ, "PATH": f"{bwrap.parent}:{os.environ['PATH']}"}


def command(
    *arguments: str, env: dict[str, str] | None = None, before: str = "pass"
) -> subprocess.CompletedProcess[str]:
    start = f"import sys; {before}; from rcj_challenges.cli import main; main()"
    line = [sys.executable, "-c", start, *arguments]
    return subprocess.run(line, capture_output=True, text=True, encoding="utf-8", env=env, check=False)


def sandbox(out: Path) -> dict[str, object]:
    (result,) = out.glob("*/result.json")
    found: dict[str, object] = json.loads(result.read_text(encoding="utf-8"))["sandbox"]
    return found


def test_run_names_a_dropped_layer_on_the_terminal_and_in_the_record(tmp_path: Path, broken: dict[str, str]) -> None:
    done = command(*RUN, "--out", str(tmp_path / "runs"), env=broken)
    assert done.returncode == 0
    assert "without the layer bubblewrap" in " ".join(done.stderr.split())
    recorded = sandbox(tmp_path / "runs")
    assert "bubblewrap" in recorded["dropped"]  # type: ignore[operator]
    assert "bubblewrap" not in recorded["layers"]  # type: ignore[operator]


def test_strict_refuses_to_drop_a_layer_and_records_nothing(tmp_path: Path, broken: dict[str, str]) -> None:
    done = command(*RUN, "--out", str(tmp_path / "runs"), "--sandbox", "strict", env=broken)
    assert done.returncode == 2
    assert done.stderr.startswith("error[isolation-missing]")
    assert not (tmp_path / "runs").exists()


def test_check_names_a_dropped_layer_in_its_report(broken: dict[str, str]) -> None:
    done = command("check", "ball_chaser", "--set", "match.half_s=1", "--json", env=broken)
    (file,) = json.loads(done.stdout)["files"]
    assert {tuple(match["dropped_layers"]) for match in file["matches"]} == {("bubblewrap",)}
    assert "without the layer bubblewrap" in " ".join(done.stderr.split())


@pytest.mark.skipif("bubblewrap" not in isolation.active_layers("auto"), reason="bubblewrap is not installed")
def test_no_layer_is_dropped_where_the_caller_ignores_the_end_of_processes(tmp_path: Path) -> None:
    ignoring = "import signal; signal.signal(signal.SIGCHLD, signal.SIG_IGN)"
    done = command(*RUN, "--out", str(tmp_path / "runs"), "--sandbox", "strict", before=ignoring)
    assert done.returncode == 0, done.stderr
    assert "bubblewrap" in sandbox(tmp_path / "runs")["layers"]  # type: ignore[operator]
