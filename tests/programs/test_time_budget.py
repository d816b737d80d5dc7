"""What time a program is charged: CPU and idle time from its release to its answer, and never what others hold up."""

from __future__ import annotations

import hashlib
import os
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from rcj_challenges.programs import process_stats, time_budget
from rcj_challenges.programs.time_budget import ProcessTimes, ThreadTimes, TimeBudget, TimeLimits

MAIN, HELPER = 1, 2
LIMITS = TimeLimits(start_s=30.0, step_s=5.0, half_s=120.0)


class Machine:
    """A process whose threads run, wait for a processor or sleep as a test says, and the budget that it is charged to."""

    def __init__(self, limits: TimeLimits = LIMITS, *, has_ready_times: bool = True) -> None:
        self.now_s = 1000.0
        self.cpu_s = 0.0
        self.threads: dict[int, ThreadTimes] = {MAIN: ThreadTimes()}
        self.runnable: set[int] = set()
        self.is_gone = False
        self.has_ready_times = has_ready_times
        self.budget = TimeBudget(limits, self._read, lambda thread: thread in self.runnable)
        self.budget.answered(self.now_s)

    def _read(self) -> ProcessTimes | None:
        if self.is_gone:
            return None
        return ProcessTimes(self.cpu_s, dict(self.threads) if self.has_ready_times else None)

    def passes(self, seconds: float, running: dict[int, float] | None = None, ready: dict[int, float] | None = None):
        """Let wall time pass in which threads run and are ready for so long, and sleep for the rest."""
        self.now_s += seconds
        for thread in {*(running or {}), *(ready or {})}:
            ran_s, ready_s = (running or {}).get(thread, 0.0), (ready or {}).get(thread, 0.0)
            before = self.threads.get(thread, ThreadTimes())
            self.threads[thread] = ThreadTimes(before.running_s + ran_s, before.ready_s + ready_s, before.runs + 1)
            self.cpu_s += ran_s

    def short_step(self, seconds: float, running: dict[int, float] | None = None):
        """Let it answer before it is measured."""
        self.passes(seconds, running)
        self.budget.answered_within(seconds)

    def step(self, seconds: float, running: dict[int, float] | None = None, ready: dict[int, float] | None = None):
        """Release it, look at it, let that pass, and take its answer."""
        self.budget.look(self.now_s)
        self.passes(seconds, running, ready)
        self.budget.answered(self.now_s)


@pytest.mark.parametrize(
    ("running", "ready", "charged_s"),
    [
        ({MAIN: 2.0}, {}, 2.0),  # it computes
        ({}, {}, 2.0),  # it sleeps
        ({MAIN: 0.5}, {}, 2.0),  # it computes, then sleeps
        ({MAIN: 0.5}, {MAIN: 1.5}, 0.5),  # others have the processors
        ({HELPER: 0.5}, {HELPER: 1.5}, 0.5),
        ({MAIN: 2.0, HELPER: 2.0}, {}, 4.0),  # each of two threads computes for the whole time
        ({MAIN: 1.0, HELPER: 1.0}, {}, 3.0),  # both for half of it: at the same time, as far as is known
        (dict.fromkeys(range(30), 0.01), dict.fromkeys(range(30), 0.1), 0.3 + 2.0 - 0.11),
    ],
)
def test_a_program_pays_for_computing_and_for_real_waits(running, ready, charged_s) -> None:
    machine = Machine()
    machine.step(2.0, running, ready)
    assert machine.budget.charged_s == pytest.approx(charged_s, abs=0.007)
    assert machine.budget.slowest_s == pytest.approx(charged_s, abs=0.003)


def test_what_it_computes_outside_its_intervals_is_only_counted() -> None:
    machine = Machine()
    machine.step(1.0, {MAIN: 1.0})
    machine.passes(10.0, {HELPER: 10.0})
    machine.step(1.0, {MAIN: 1.0})
    assert machine.budget.charged_s == pytest.approx(2.0, abs=0.005)
    assert machine.budget.background_s == pytest.approx(10.0, abs=0.005)


def test_threads_that_end_within_a_step_have_computed_and_not_slept() -> None:
    machine = Machine()
    machine.budget.look(machine.now_s)
    machine.passes(2.0, {HELPER: 2.0})
    del machine.threads[HELPER]
    machine.budget.answered(machine.now_s)
    assert machine.budget.charged_s == pytest.approx(2.0, abs=0.005)


def test_a_new_thread_with_the_number_of_an_ended_one_pays_for_itself_alone() -> None:
    machine = Machine()
    machine.passes(5.0, {HELPER: 5.0})
    machine.budget.look(machine.now_s)
    machine.threads[HELPER] = ThreadTimes()
    machine.passes(2.0, {HELPER: 0.5})
    machine.budget.answered(machine.now_s)
    assert machine.budget.charged_s == pytest.approx(2.0, abs=0.005)  # it has slept for 1.5 s


def test_short_steps_are_charged_their_cpu_time_and_at_most_their_wall_time() -> None:
    machine = Machine()
    for computes_s, lasts_s in ((0.0005, 0.0015), (0.003, 0.001)):
        machine.short_step(lasts_s, {MAIN: computes_s})
        machine.budget.settle()
    assert machine.budget.charged_s == pytest.approx(0.0015)
    assert machine.budget.background_s == pytest.approx(0.002)


def test_short_steps_reach_the_limit_of_a_half_by_their_cpu_time_only() -> None:
    machine = Machine(LIMITS._replace(half_s=0.01))
    for _ in range(45):
        machine.short_step(0.001, {MAIN: 0.0002})
        machine.budget.settle()
        assert machine.budget.exceeded is None
    machine.short_step(0.002, {MAIN: 0.002})
    machine.budget.settle()
    assert machine.budget.exceeded == "half_timeout"


@pytest.mark.parametrize(
    ("limits", "steps", "exceeded"),
    [
        (LIMITS, [4.9], None),
        (LIMITS, [5.1], "step_timeout"),
        (LIMITS._replace(half_s=9.0), [4.0, 4.0], None),
        (LIMITS._replace(half_s=9.0), [4.0, 4.0, 1.1], "half_timeout"),
    ],
)
@pytest.mark.parametrize("busy", [False, True], ids=["asleep", "computing"])
def test_the_limits_of_a_step_and_of_a_half(limits, steps, exceeded, busy) -> None:
    machine = Machine(limits)
    for lasts_s in steps:
        machine.step(lasts_s, {MAIN: lasts_s} if busy else {})
    assert machine.budget.exceeded == exceeded


def test_the_start_has_a_limit_of_its_own() -> None:
    machine = Machine()
    budget = TimeBudget(LIMITS, machine._read, lambda _: False)
    budget.look(machine.now_s)
    machine.passes(29.0, {MAIN: 29.0})
    budget.look(machine.now_s)
    assert budget.exceeded is None
    machine.passes(1.5)
    budget.look(machine.now_s)
    assert budget.exceeded == "start_timeout"


def test_until_its_answer_was_looked_for_a_start_is_charged_no_idle_time() -> None:
    """The match loads the physics meanwhile, and takes long for it on a busy computer."""
    machine = Machine()
    budget = TimeBudget(LIMITS, machine._read, lambda _: False)
    machine.passes(40.0, {MAIN: 2.0})
    budget.answered(machine.now_s)
    assert (budget.started_s, budget.charged_s, budget.exceeded) == (pytest.approx(2.0), 0.0, None)


def test_a_wait_for_a_processor_that_is_not_over_counts_as_ready() -> None:
    """The kernel counts it when it is over."""
    machine = Machine()
    machine.budget.look(machine.now_s)
    machine.runnable = {MAIN}
    for _ in range(3):
        machine.passes(4.0)
        machine.budget.look(machine.now_s)
        assert machine.budget.exceeded is None
    machine.passes(0.1, {MAIN: 0.1}, {MAIN: 12.0})
    machine.budget.answered(machine.now_s)
    assert machine.budget.charged_s == pytest.approx(0.1)
    assert machine.budget.exceeded is None


def test_time_in_which_the_match_itself_stood_still_is_not_charged() -> None:
    machine = Machine()
    machine.budget.look(machine.now_s)
    machine.passes(3600.0, {MAIN: 0.5})
    machine.budget.answered(machine.now_s, lost_s=3599.5)
    assert machine.budget.charged_s == pytest.approx(0.5)


def test_the_time_of_a_process_that_is_gone_counts_as_idle() -> None:
    machine = Machine()
    machine.budget.look(machine.now_s)
    machine.is_gone = True
    machine.passes(3.0, {MAIN: 3.0})
    machine.budget.answered(machine.now_s)
    assert machine.budget.charged_s == pytest.approx(3.0)


def test_what_comes_after_the_budget_is_closed_is_free() -> None:
    machine = Machine()
    machine.step(1.0, {MAIN: 1.0})
    machine.budget.close()
    machine.step(1.0, {MAIN: 1.0})
    assert machine.budget.charged_s == pytest.approx(1.0)


class TestWithoutReadyTimes:
    """Windows and macOS: only long stretches without CPU time are idle."""

    @pytest.mark.parametrize(
        ("steps", "charged_s"),
        [
            ([(4.0, 1.0)], 1.0),  # it slept, or others had the processors
            ([(4.9, 0.0)], 0.0),
            ([(5.1, 0.0)], 5.1),
            ([(2.0, 0.0), (2.0, 0.0), (2.0, 0.0)], 6.0),
            ([(6.0, 0.061)], 0.061),
            ([(6.0, 0.059)], 6.059),
        ],
    )
    def test_idle_time(self, steps, charged_s) -> None:
        machine = Machine(has_ready_times=False)
        for lasts_s, computes_s in steps:
            machine.step(lasts_s, {MAIN: computes_s})
        assert machine.budget.charged_s == pytest.approx(charged_s, abs=0.007)

    def test_short_steps_that_sleep_add_up(self, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(time_budget, "MEASURED_AFTER_S", 0.25)
        machine = Machine(has_ready_times=False)
        for _ in range(26):
            machine.short_step(0.2)
        assert machine.budget.charged_s == pytest.approx(5.0, abs=0.3)


@contextmanager
def on_one_processor() -> Iterator[None]:
    allowed = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {min(allowed)})
    try:
        yield
    finally:
        os.sched_setaffinity(0, allowed)


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux reports it")
def test_the_kernel_reports_for_how_long_threads_were_ready() -> None:
    """Two threads in a loop on one processor stand in each other's way."""
    times = process_stats.process_times(os.getpid())
    if times is None or times.threads is None:
        pytest.skip("this kernel does not count it")
    held_up_s: list[float] = []
    ready_s: list[float] = []

    def compute() -> None:
        before_s = process_stats.held_up_here_s()
        end_s = time.monotonic() + 60
        while process_stats.held_up_here_s() - before_s < 0.01 and time.monotonic() < end_s:
            hashlib.sha256(bytes(100_000))
        held_up_s.append(process_stats.held_up_here_s() - before_s)
        now = process_stats.process_times(os.getpid())
        ready_s.append(now.threads[threading.get_native_id()].ready_s)

    with on_one_processor():
        threads = [threading.Thread(target=compute) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    assert max(held_up_s) >= 0.01
    assert max(ready_s) >= 0.01


@pytest.mark.skipif(sys.platform != "linux", reason="only asked for on Linux")
def test_a_thread_that_sleeps_is_not_runnable() -> None:
    asleep, end = threading.Event(), threading.Event()
    thread = threading.Thread(target=lambda: (asleep.set(), end.wait()))
    thread.start()
    asleep.wait()
    time.sleep(0.05)
    runnable = process_stats.is_runnable(os.getpid(), thread.native_id)
    end.set()
    thread.join()
    assert not runnable
    assert process_stats.is_runnable(os.getpid(), os.getpid())


@pytest.mark.skipif(sys.platform == "win32", reason="there the job object reports it")
def test_the_system_reports_the_cpu_time_of_a_process() -> None:
    before = process_stats.process_times(os.getpid())
    began_s = time.process_time()
    while time.process_time() - began_s < 0.02:
        pass
    after = process_stats.process_times(os.getpid())
    assert before is not None
    assert after is not None
    assert after.cpu_s - before.cpu_s >= (0.02 if sys.platform == "linux" else 0.0)


@pytest.mark.parametrize(
    ("reported", "seconds"),
    [("  0:01.25\n", 1.25), ("00:01:02", 62.0), ("2-03:04:05", 183_845.0), ("90:00.00", 5400.0)],
)
def test_times_of_ps_are_read(reported: str, seconds: float) -> None:
    assert process_stats.seconds_of(reported) == seconds
