"""Programs that take more than they may, of time, memory or disk: when they are stopped, and with which message."""

from __future__ import annotations

import signal
import sys
import time
from pathlib import Path
from types import SimpleNamespace

import pytest
from fake_match import FakeMatch, fault_of

from rcj_challenges.programs import pipes, processes
from rcj_challenges.submissions.team import open_team

posix = pytest.mark.skipif(sys.platform == "win32", reason="POSIX only")


needs_linux = pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells how many threads a process has")


def test_a_program_that_never_steps_is_stopped_at_its_start(either_match: FakeMatch) -> None:
    either_match.limits = either_match.limits.model_copy(update={"start_s": 0.7})
    fault = fault_of(either_match, "faults/never_steps")
    assert (fault.kind, fault.tick) == ("start_timeout", 0)
    assert fault.detail == "the program used more than 0.7 s until its first step"


def test_a_program_that_hangs_is_stopped_at_the_limit_and_its_log_shows_where(tmp_path: Path) -> None:
    match = FakeMatch(tmp_path, step_s=0.4)
    began = time.perf_counter()
    played = match.play("faults/hangs_in_play", 10)
    assert played.fault is not None
    assert (played.fault.kind, played.fault.tick) == ("step_timeout", 2)
    assert played.fault.detail == "the program used more than 0.4 s for one step"
    assert time.perf_counter() - began < 60  # it would hang for ever
    assert "now it hangs" in played.log
    where = played.log.split("It was here, the innermost call first:\n")[1].splitlines()
    assert where[0].startswith('  File "hangs_in_play.py", line ')
    assert where[1].startswith("[step_timeout] Y1 at tick 2 (0.064 s): ")


@pytest.mark.parametrize("asked", ["by a signal", "by its watch"])
def test_the_place_of_a_hang_is_listed_before_those_of_other_threads(
    asked: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    by_watch = asked == "by its watch" or sys.platform == "win32"
    if by_watch and sys.platform != "win32":
        monkeypatch.setattr(processes, "signal", SimpleNamespace(SIGABRT=0, SIGCONT=0, SIGKILL=signal.SIGKILL))
    (tmp_path / "t").mkdir()
    (tmp_path / "t" / "robot.py").write_text(
        "import queue, threading\n"
        "lines = queue.Queue()\n"
        "def write_log():\n"
        "    while True: lines.get()\n"
        "for _ in range(2): threading.Thread(target=write_log, daemon=True).start()\n"
        "def turn():\n"
        "    while True: pass\n"
        "turn()\n",
        encoding="utf-8",
    )
    played = FakeMatch(tmp_path, portable=by_watch, start_s=0.7).play(open_team(tmp_path / "t"))
    where = played.log.split("It was here, the innermost call first:\n")[1].splitlines()
    assert where[:6] == [
        '  File "robot.py", line 7 in turn',
        '  File "robot.py", line 8 in <module>',
        "Beside it, another thread was here:",
        '  File "robot.py", line 4 in write_log',
        "Beside it, another thread was here:",
        '  File "robot.py", line 4 in write_log',
    ]


def test_a_program_that_is_slow_on_every_step_is_stopped_by_the_sum(tmp_path: Path) -> None:
    fault = fault_of(FakeMatch(tmp_path, half_s=0.3), "faults/slow_on_every_step", 1000)
    assert fault.kind == "half_timeout"
    assert fault.detail == "the program used more than 0.3 s for all its steps"
    assert 1 <= fault.tick <= 20  # 5, and more where other programs take the processor: that time is not charged


@posix
def test_no_time_runs_out_while_the_match_itself_stands_still(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Ctrl-Z, and ``fg`` after an hour: each program is charged what one step may take, and no more."""
    stood_s, bodies = [0.0], list[bytes | None]()
    clock = SimpleNamespace(perf_counter=lambda: time.perf_counter() + stood_s[0])
    monkeypatch.setattr("rcj_challenges.programs.program.time", clock)
    receive = pipes.PolledPipes.receive

    def stopped_once(channel: pipes.PolledPipes, timeout_s: float) -> bytes | None:
        body = receive(channel, timeout_s)
        bodies.append(body)
        if len(bodies) - bodies.count(None) == 4:
            stood_s[0] = 3600.0
        return body

    monkeypatch.setattr(pipes.PolledPipes, "receive", stopped_once)
    match = FakeMatch(tmp_path, step_s=20, half_s=100, portable=False)
    played = match.play("from controller import Robot\nrobot = Robot()\nwhile robot.step(32) != -1: pass\n", 30)
    assert played.fault is None, played.fault


@pytest.mark.skipif(sys.platform == "darwin", reason="macOS takes no limit on memory; the watch has its own test")
def test_a_program_that_takes_too_much_memory_is_ended(tmp_path: Path) -> None:
    fault = fault_of(FakeMatch(tmp_path, memory_mb=128), "faults/wants_too_much_memory")
    assert (fault.kind, fault.tick) == ("memory", 1)
    assert fault.detail == "MemoryError (wants_too_much_memory.py, line 7)"


@posix
def test_where_the_system_does_not_limit_memory_a_watch_does(tmp_path: Path) -> None:
    match = FakeMatch(tmp_path, portable=True, memory_mb=128)
    program = """
import resource
from controller import Robot
robot = Robot()
robot.step(32)
heap = []
while True:
    try:
        heap.append(bytearray(b"x") * (1 << 20))
    except MemoryError:
        pass
"""
    fault = fault_of(match, program)
    assert (fault.kind, fault.tick) == ("memory", 1)


def test_a_flood_of_output_is_stopped_at_the_same_tick_in_every_run_whatever_the_program_catches(
    tmp_path: Path,
) -> None:
    match = FakeMatch(tmp_path, output_mb=0.1)
    played = match.play("faults/floods_its_output", 30)
    assert played.fault is not None
    # 20 lines of 1000 bytes a tick: the fifth tick fills the 100 kB, the sixth breaks them.
    assert (played.fault.kind, played.fault.tick) == ("output_flood", 6)
    assert played.fault.detail == "the program printed more than 0.1 MB"
    assert (tmp_path / "logs" / "Y1.log").stat().st_size < 101_000


WRITES_ON_EVERY_TICK = """
from controller import Robot
robot = Robot()
while True:
    with open("diary", "ab") as file:
        file.write(bytes(5_000))
    if robot.step(32) == -1:
        break
"""


PRINTS_PAST_THE_COUNTER = """
import os
from controller import Robot
robot = Robot()
while robot.step(32) != -1:
    os.write(1, bytes(20_000))
"""


STARTS_THREADS = """
import threading
from controller import Robot
robot = Robot()
threading.stack_size(1 << 16)
for _ in range(10):
    threading.Thread(target=threading.Event().wait, daemon=True).start()
while robot.step(32) != -1:
    pass
"""


@pytest.mark.parametrize("wait_s", [0.001, 1000.0], ids=["on a slow machine", "on a fast machine"])
class TestTheTickOfAFaultDoesNotDependOnHowLongTheMatchWaits:
    """Who takes more than it may is out at the same tick in every run, unless it takes more than twice as much."""

    @pytest.fixture(autouse=True)
    def looked_at(self, wait_s, monkeypatch):
        monkeypatch.setattr("rcj_challenges.programs.program._SLICE_S", wait_s)

    def test_what_is_written_little_by_little(self, tmp_path: Path) -> None:
        fault = fault_of(FakeMatch(tmp_path, scratch_mb=1), WRITES_ON_EVERY_TICK, 300)
        assert (fault.kind, fault.tick) == ("output_flood", 256)
        assert fault.detail == "the program wrote more than 1 MB into its folder"

    def test_what_is_written_before_the_first_step(self, tmp_path: Path) -> None:
        program = f'open("table", "wb").write(bytes(1_500_000)){WRITES_ON_EVERY_TICK}'
        fault = fault_of(FakeMatch(tmp_path, scratch_mb=1), program, 300)
        assert (fault.kind, fault.tick) == ("output_flood", 0)

    def test_what_is_printed_past_the_counter(self, tmp_path: Path) -> None:
        # The limit and its slack are passed at tick 9, and the log is looked at when it calls step for the 16th time.
        fault = fault_of(FakeMatch(tmp_path, output_mb=0.1), PRINTS_PAST_THE_COUNTER, 300)
        assert (fault.kind, fault.tick) == ("output_flood", 15)

    @needs_linux
    def test_threads(self, tmp_path: Path) -> None:
        fault = fault_of(FakeMatch(tmp_path, processes=7), STARTS_THREADS, 300)
        assert (fault.kind, fault.tick) == ("memory", 0)


@pytest.mark.parametrize("threads", [0, 10])
def test_how_a_program_ended_does_not_depend_on_how_many_of_its_threads_have_ended_by_then(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, threads: int
) -> None:
    monkeypatch.setattr(processes.Process, "threads", lambda _: threads)
    assert fault_of(FakeMatch(tmp_path, processes=7), "x = 1\nraise RuntimeError('no room')\n", 3).kind == "crash"


def test_a_program_that_writes_fast_is_stopped_before_its_folder_is_looked_through_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("rcj_challenges.programs.program._SLICE_S", 1e-6)
    # Only while the match waits is the folder looked at earlier: so it computes too, and the match has to wait for it.
    fast = WRITES_ON_EVERY_TICK.replace("5_000", "100_000").replace("if robot", "sum(range(50_000))\n    if robot")
    fault = fault_of(FakeMatch(tmp_path, scratch_mb=1), fast, 300)
    assert fault.kind == "output_flood"
    assert 19 <= fault.tick < 60


def test_what_it_holds_is_looked_at_in_each_256_ticks_and_what_only_its_memory_holds_in_each_1024(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    looks: list[bool] = []

    def nameless_bytes(*_: object, in_memory: bool) -> float:
        looks.append(in_memory)
        return 0.0

    monkeypatch.setattr("rcj_challenges.programs.program._SLICE_S", 60.0)  # a slow computer looks more often
    monkeypatch.setattr(processes.Process, "nameless_bytes", nameless_bytes)
    steps = "from controller import Robot\nrobot = Robot()\nwhile robot.step(32) != -1:\n    pass\n"
    assert FakeMatch(tmp_path).play(steps, 1100).fault is None
    assert looks[-5:] == [True, False, False, False, True]  # before the first step by wall time, then at ticks
