"""Limits of time count what a program computes and really waits for, not how busy the computer is."""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
from fake_match import FakeMatch, robot_spec, values_at

from rcj_challenges.programs import isolation, pool as program_pool
from rcj_challenges.programs.program import Program
from rcj_challenges.core.errors import HostError
from rcj_challenges.core.play import Fault
from rcj_challenges.core.traffic import Observation

needs_linux = pytest.mark.skipif(sys.platform != "linux", reason="only Linux reports for how long a thread was ready")

STEPS = "while robot.step(32) != -1:\n    pass\n"
ROBOT = "from controller import Robot\nrobot = Robot()\nrobot.step(32)\n"
COMPUTES = "import hashlib\ndef compute(times):\n    for _ in range(times): hashlib.sha256(bytes(1_000_000)).digest()\n"
SLEEPS = "import ctypes\ndef sleep(seconds):\n    ctypes.CDLL(None).usleep(int(1e6 * seconds))\n"


@contextmanager
def busy_computer(processes: int) -> Iterator[None]:
    """One processor for this process and what it starts, and so many others that compute on it without end."""
    allowed = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {min(allowed)})
    busy = [sys.executable, "-S", "-c", "while True: pass"]
    # Linux may share processors between sessions, and programs have sessions of their own.
    others = [subprocess.Popen(busy, start_new_session=True) for _ in range(processes)]
    try:
        yield
    finally:
        for other in others:
            other.kill()
        for other in others:
            other.wait()
        os.sched_setaffinity(0, allowed)


@needs_linux
def test_a_step_that_computes_is_within_its_limit_on_a_busy_computer(tmp_path: Path) -> None:
    program = f"{COMPUTES}{ROBOT}compute(150)\n{STEPS}"
    match = FakeMatch(tmp_path, step_s=0.6)
    with busy_computer(8):
        assert match.play(program, 3).fault is None


@needs_linux
@pytest.mark.parametrize("portable", [False, True], ids=["polled", "threaded"])
def test_a_program_that_has_answered_pays_nothing_while_the_match_waits_for_another(
    tmp_path: Path, *, portable: bool
) -> None:
    match = FakeMatch(tmp_path, portable=portable)
    programs: dict[str, Program] = {}
    with match.pool() as pool:
        for name, wait in (("Y1", "sleep(0.3)"), ("Y2", "sleep(0.02)")):
            team = match.team(f"{SLEEPS}{ROBOT}{wait}\n{STEPS}")
            programs[name] = pool.add(robot_spec(name), team, team.single)
        pool.launch()
        for tick in range(3):
            for program in programs.values():
                if tick:
                    program.release(Observation(tick, values_at(tick), []))
            for program in programs.values():
                assert not isinstance(program.collect(), Fault)
    slow, quick = programs["Y1"].budget, programs["Y2"].budget
    assert 0.1 < slow.slowest_s < 0.5
    assert 0.0 < quick.slowest_s < 0.7 * slow.slowest_s


@needs_linux
def test_a_program_that_computes_much_beside_its_steps_is_suspended_between_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("rcj_challenges.programs.program.BACKGROUND_S", 0.6)
    thread = "threading.Thread(target=compute, args=(10**6,), daemon=True).start()\n"
    match, used_s = FakeMatch(tmp_path), list[float]()
    with match.pool() as pool:
        team = match.team(f"import threading\n{COMPUTES}{ROBOT}{thread}{STEPS}")
        driver = pool.add(robot_spec(), team, team.single)
        pool.launch()
        for tick in range(16 * 40):
            if tick:
                driver.release(Observation(tick, values_at(tick), []))
            assert not isinstance(driver.collect(), Fault)
            if tick % 16 == 4:  # first before it has used it all
                before_s = driver._process.times().cpu_s
                time.sleep(0.15)
                used_s.append(driver._process.times().cpu_s - before_s)
                if driver.budget.background_s > 0.6:
                    break
    assert used_s[0] > 0.01
    assert used_s[-1] < 0.01


@needs_linux
@pytest.mark.nightly
def test_a_program_that_ignores_the_signal_of_its_cpu_limit_is_killed_and_the_fault_is_timed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(isolation, "processor_s", lambda _: 1)
    ignores = "import signal\nsignal.signal(signal.SIGXCPU, signal.SIG_IGN)\n"
    fault = FakeMatch(tmp_path).play(f"{ignores}{ROBOT}while True: pass\n", 2).fault
    assert fault is not None
    assert (fault.kind, fault.tick, fault.timed) == ("crash", 1, True)


def test_a_computer_that_is_too_busy_for_the_match_ends_it_and_blames_no_program(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(program_pool, "_MAX_HELD_UP", 0.001)  # of 20 s to start and 120 s to play
    match = FakeMatch(tmp_path)
    with pytest.raises(HostError) as raised:
        match.play(f"{SLEEPS}{ROBOT}sleep(3)\n{STEPS}", 3)
    assert raised.value.code == "host-too-busy"
