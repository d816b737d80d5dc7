"""The clock of threads beside the one that steps: it follows the match, and no thread waits for ever."""

from __future__ import annotations

import functools
import importlib.util
import itertools
import math
import sys
import threading
import time
from collections.abc import Callable
from types import ModuleType
from typing import Any

import pytest
from fake_match import FakeMatch

from rcj_challenges.programs.program_side.controller import _background_clock
from rcj_challenges.programs.program_side.controller._blocking_calls import BlockingCalls
from rcj_challenges.programs.program_side.controller._clock import Clock

TICK_S = 0.032


@pytest.fixture
def clock() -> Clock:
    """Of a program that has taken its first step."""
    clock = Clock(32_000_000)
    clock.step_began()
    clock.tick_began(1)
    return clock


def stepped(clock: Clock, tick: int) -> None:
    clock.step_began()
    clock.tick_began(tick)


@pytest.fixture
def real_time_goes_on_by_looking(monkeypatch: pytest.MonkeyPatch) -> None:
    """Real time as it is looked at, 0.01 ms for each look: how long others have the processor counts for nothing."""
    looks = itertools.count()
    monkeypatch.setattr(_background_clock, "real_monotonic", lambda: 1e-5 * next(looks))
    monkeypatch.setattr(_background_clock, "real_process_time", lambda: 0.0)


def run_beside(work: Callable[[], object]) -> float:
    """Let another thread work while this one, that steps, waits for it. Returns how long that took in real s."""
    began_s = time.perf_counter()
    thread = threading.Thread(target=work, daemon=True)
    thread.start()
    thread.join(60.0)
    assert not thread.is_alive(), "it waits for a clock that stands still"
    return time.perf_counter() - began_s


def quickest_beside(work: Callable[[], object], enough_s: float) -> float:
    """Run it again and again until it took less than enough: on a busy machine any single time may be a long one."""
    quickest_s = math.inf
    for _ in range(50):
        quickest_s = min(quickest_s, run_beside(work))
        if quickest_s < enough_s:
            break
    return quickest_s


def look_until(clock: Clock, seconds: float) -> int:
    """What programs do that think for so long: returns how often they looked."""
    began_s, looked = clock.now_s(), 0
    while clock.now_s() - began_s < seconds:
        looked += 1
    return looked


def test_clock_goes_on_for_a_thread_that_the_stepping_thread_waits_for(clock: Clock) -> None:
    # Not only after the standstill that real time needs to count.
    assert quickest_beside(lambda: look_until(clock, 0.005), 0.09) < 0.09
    assert clock.missed_ticks() == 0


def test_thread_that_the_stepping_thread_waits_for_sleeps_in_real_time(clock: Clock) -> None:
    assert 0.02 <= quickest_beside(lambda: clock.sleep(0.02), 0.1) < 0.1
    assert clock.missed_ticks() == 0


def test_a_wait_with_a_limit_takes_about_as_long_where_the_thread_that_steps_is_idle(clock: Clock) -> None:
    """``await loop.run_in_executor(None, robot.step, 32)``, then ``await asyncio.sleep(0.001)``."""
    wait = BlockingCalls(clock)._patient(lambda _, timeout: time.sleep(timeout))
    assert 0.02 <= quickest_beside(lambda: wait(None, 0.02), 0.1) < 0.1
    assert clock.missed_ticks() == 0


def test_inside_a_step_no_real_time_counts(clock: Clock) -> None:
    """Other programs may take as long as they like to start: the same tick follows."""
    clock.beside.ahead_ns()  # somebody waits
    clock.step_began()
    before = clock.beside.read_ns()
    time.sleep(0.12)
    run_beside(lambda: [clock.now_s() for _ in range(1_000)])
    assert clock.beside.read_ns() == before == 0


@pytest.mark.usefixtures("real_time_goes_on_by_looking")
def test_what_the_clock_is_ahead_is_taken_back_and_it_never_runs_back(clock: Clock) -> None:
    shown = []
    for tick in range(2, 12):
        run_beside(lambda: look_until(clock, 0.005))
        run_beside(lambda: shown.append(clock.now_s()))
        stepped(clock, tick)
        run_beside(lambda: shown.append(clock.now_s()))
    assert shown == sorted(shown)
    assert shown[-1] < 11 * TICK_S + 0.03


def test_no_thread_counts_as_stuck_while_another_computes(clock: Clock, monkeypatch: pytest.MonkeyPatch) -> None:
    """Who polls does not run ahead, for less than the while after which real time counts."""
    monkeypatch.setattr(_background_clock, "real_process_time", time.perf_counter)
    monkeypatch.setattr(_background_clock, "_HAS_FINE_CPU_TIMES", True)
    monkeypatch.setattr(_background_clock, "_STANDSTILL_S", 10.0)
    run_beside(lambda: [clock.now_s() for _ in range(250)])
    assert clock.beside.ahead_ns() == 0


@pytest.fixture
def beside_on_windows(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """The module as Python up to 3.12 loads it on Windows: there ``time.monotonic`` goes on 64 times a second."""
    monotonic_s = time.monotonic
    monkeypatch.setattr(time, "monotonic", lambda: math.floor(monotonic_s() * 64) / 64)
    spec = importlib.util.spec_from_file_location(
        f"{_background_clock.__package__}._background_clock_on_windows", _background_clock.__file__
    )
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_real_time_counts_finely_on_all_systems(beside_on_windows: ModuleType) -> None:
    """Who waits for so long is never ahead by more than it really waited, such as by 0.016 s after 0.002 s."""
    seen = []

    def wait(beside: Any) -> None:
        time.sleep(0.002)  # the thread that steps is to wait for this one by then
        began_s, place = time.perf_counter(), beside.place()
        time.sleep(0.002)
        beside.compare(place)
        seen.append((beside.ahead_ns() / 1e9, time.perf_counter() - began_s))

    for _ in range(20):
        beside = beside_on_windows.BackgroundClock()
        run_beside(functools.partial(wait, beside))
    assert all(ahead_s <= passed_s for ahead_s, passed_s in seen), seen
    assert any(0.002 <= ahead_s < 0.015 for ahead_s, _ in seen), seen


def until_it_stands_still(thread: int | None) -> None:
    for _ in range(500):
        if not _background_clock._would_run(thread):
            return
        time.sleep(0.001)


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells")
def test_a_thread_that_only_waits_for_a_processor_is_not_stuck() -> None:
    asked = threading.Event()
    waits = threading.Thread(target=asked.wait)
    waits.start()
    until_it_stands_still(waits.native_id)
    found = _background_clock._would_run(threading.get_native_id()), _background_clock._would_run(waits.native_id)
    asked.set()
    waits.join()
    until_it_stands_still(waits.native_id)  # its end is reported a moment before it happens
    assert (*found, _background_clock._would_run(waits.native_id)) == (True, False, False)


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells")
def test_a_program_in_its_sandbox_finds_out_whether_another_of_its_threads_would_run(match: FakeMatch) -> None:
    """One that computes outside of Python's lock does; one that waits does not."""
    program = """
import hashlib, sys, threading
from controller import Robot
from controller._background_clock import others_would_run
robot = Robot()
def compute():
    while not over: hashlib.sha256(much)
over, much = False, bytes(10_000_000)
waits = threading.Event()
threading.Thread(target=waits.wait, daemon=True).start()
robot.step(32)
print(any([not others_would_run() for _ in range(1000)]))
worker = threading.Thread(target=compute)
worker.start()
print(any([others_would_run() for _ in range(1000)]))
over = True
worker.join()
robot.step(32)
"""
    assert match.play(program, 2).said == ["True", "True"]


def test_loop_that_plans_for_ten_ms_runs_some_hundred_times(clock: Clock) -> None:
    assert 250 < look_until(clock, 0.01) < 350
