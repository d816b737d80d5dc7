"""However ``simulate`` ends, the matches that it plays end with it, and with them all programs."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from rcj_challenges.records.result import read_result

COMMAND = [sys.executable, "-m", "rcj_challenges"]
POSIX = pytest.mark.skipif(os.name != "posix", reason="processes are listed and killed as POSIX has it")
ENDS_WITHIN_S = 20.0  # one second, and a very busy machine; they would play for an hour
UNHURRIED = """
import select
from controller import Robot
robot, waits = Robot(), select.poll()
while robot.step(32) != -1:
    waits.poll(20)
"""
"""Takes some real time for each step, so that a match that has no end leaves the processors to others."""


@pytest.fixture
def many(duel: list[str]) -> list[str]:
    """A command that plays several matches of one robot against another."""
    return [*COMMAND, "simulate", *duel]


def descendants_of(pid: int) -> dict[int, str]:
    """Return the command of each process that a process has started, and that those have started."""
    listed = subprocess.run(["ps", "-A", "-o", "pid=,ppid=,args="], capture_output=True, text=True, check=True).stdout
    rows = [line.split(None, 2) for line in listed.splitlines()]
    found: dict[int, str] = {}
    fresh = {pid}
    while fresh:
        fresh = {int(row[0]) for row in rows if int(row[1]) in fresh}
        found |= {int(row[0]): row[2] for row in rows if int(row[0]) in fresh}
    return found


def running(pids: set[int]) -> set[int]:
    listed = subprocess.run(["ps", "-A", "-o", "pid=,stat="], capture_output=True, text=True, check=True).stdout
    return pids & {int(line.split()[0]) for line in listed.splitlines() if not line.split()[1].startswith("Z")}


@pytest.fixture
def started(tmp_path: Path, many: list[str]):
    """Start two endless matches at a time; returns the process and its descendants when all programs play."""
    (tmp_path / "team.py").write_text(UNHURRIED, encoding="utf-8")
    process = subprocess.Popen(
        [*many, "--seeds=1..4", "--at-once=2", "--duration=3600", "--quiet"],
        cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
    )  # fmt: skip
    until = time.monotonic() + 60
    while sum(log.stat().st_size > 0 for log in tmp_path.glob("runs/*/referee.jsonl")) < 2:
        assert time.monotonic() < until
        assert process.poll() is None
        time.sleep(0.05)
    pids = set(descendants_of(process.pid))
    yield process, pids
    for pid in running({process.pid, *pids}):
        os.kill(pid, signal.SIGKILL)
    process.communicate(timeout=120)


@POSIX
def test_a_kill_leaves_no_match_and_no_program(tmp_path: Path, started) -> None:
    process, pids = started
    assert len(pids) >= 6  # two matches with two programs each
    process.kill()
    process.wait()
    until = time.monotonic() + ENDS_WITHIN_S
    while running(pids) and time.monotonic() < until:
        time.sleep(0.05)
    assert not running(pids)
    for folder in tmp_path.glob("runs/*"):
        assert read_result(folder).stopped == "KeyboardInterrupt", "the record is closed as after an interruption"


@POSIX
@pytest.mark.parametrize("name", ["SIGTERM", pytest.param("SIGINT", marks=pytest.mark.nightly)])
def test_an_interruption_reports_how_many_were_played(tmp_path: Path, started, name: str) -> None:
    process, pids = started
    process.send_signal(getattr(signal, name))
    _, complaint = process.communicate(timeout=120)
    assert (process.returncode, complaint) == (130, "interrupted: 0 of 4 matches were played to their end\n")
    assert not running(pids)
    assert {read_result(folder).stopped for folder in tmp_path.glob("runs/*")} == {"KeyboardInterrupt"}


def test_what_lies_in_the_current_folder_is_not_imported(tmp_path: Path, many: list[str]) -> None:
    """A folder full of submissions has modules of any name."""
    for name in ("random", "json", "numpy", "typer"):
        (tmp_path / f"{name}.py").write_text("raise SystemExit('not this one')\n", encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-P", *many[1:], "--seeds=1", "--duration=0.5", "--json"],
        cwd=tmp_path, capture_output=True, text=True, check=False, timeout=120,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["played"] == 1


READS = """
import sys
from rcj_challenges.cli import child
child.command = lambda _: print(repr(sys.stdin.read()), flush=True)
child.main()
"""


def test_lifeline_of_a_match_is_not_its_standard_input() -> None:
    """On Windows whoever asks anything about a pipe waits until the thread that reads it has got something."""
    with subprocess.Popen([sys.executable, "-c", READS], stdin=subprocess.PIPE, stdout=subprocess.PIPE) as process:
        try:
            assert process.wait(30) == 0
            assert process.stdout.read().strip() == b"''"
        finally:
            process.kill()


FAILS = """
from rcj_challenges.cli import child
from rcj_challenges.core.errors import RcjError
child.command = lambda on_error: on_error(RcjError("no code"))
child.main()
"""


def test_an_error_without_a_code_has_an_empty_one_for_the_parent() -> None:
    pipes = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL}
    with subprocess.Popen([sys.executable, "-c", FAILS], **pipes) as process:
        assert json.loads(process.stdout.read()) == {"code": ""}
