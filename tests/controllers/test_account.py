"""What a program is charged: what the match waited for it, without the time in which others held it up."""

from __future__ import annotations

import hashlib
import os
import sys
import threading
import time
from pathlib import Path

import pytest
from fake_match import FakeMatch

from rcj_challenges.controllers import tasks
from rcj_challenges.controllers.account import Account, Usage
from rcj_challenges.controllers.processes import Process

HALF_S = 120.0


def account(computed_s: float, held_up_s: float | None, waited_s: float) -> Account:
    """Of a program whose process did this while the match waited so long."""
    told = iter([Usage(2.0, None if held_up_s is None else 1.0)])
    last = Usage(2.0 + computed_s, None if held_up_s is None else 1.0 + held_up_s)
    opened = Account(HALF_S, lambda: next(told, last))
    opened.begin()
    opened.wait_was(waited_s)
    return opened


@pytest.mark.parametrize(
    ("computed_s", "held_up_s", "waited_s", "charged_s"),
    [
        (41.0, 79.0, 120.0, 41.0),  # others had the processors
        (41.0, None, 120.0, 41.0),
        (0.5, 4.8, 5.3, 0.5),  # it is waited for last
        (120.0, 0.0, 120.0, 120.0),  # it computes
        (120.0, None, 120.0, 120.0),
        (1.0, 0.0, 120.0, 120.0),  # it sleeps
        (1.0, None, 120.0, 113.0),
        (300.0, 0.0, 120.0, 120.0),  # also while nobody waits for it
        (300.0, 300.0, 120.0, 120.0),  # threads of its own hold it up
        (1.0, -0.5, 3.0, 3.0),  # threads that were held up before its first step have ended, and count no more
        (-0.3, 2.0, 1.0, 1.0),  # it has ended, and what the system tells is of another process
        (-0.3, None, 1.0, 1.0),
        (0.0, 2.0, 1.0, 0.0),  # held up also while nobody waited for it: it is charged nothing, and never less
    ],
)
def test_a_program_is_charged_what_it_made_the_match_wait(
    computed_s: float, held_up_s: float | None, waited_s: float, charged_s: float
) -> None:
    assert account(computed_s, held_up_s, waited_s).charged_s == pytest.approx(charged_s)


@pytest.mark.parametrize(
    ("stood_s", "charged_s"),
    [
        (60.0, 50.0),  # others had the processors while the match was to take the answers
        (0.0, 110.0),
        (119.0, 4.0),  # what it computed it is charged all the same
    ],
)
def test_what_the_match_itself_waited_for_a_processor_is_charged_to_nobody(stood_s: float, charged_s: float) -> None:
    """On a busy machine the answer is here long before the match can take it."""
    usages = iter([Usage(2.0, 1.0)])
    stood = iter([7.0])
    opened = Account(HALF_S, lambda: next(usages, Usage(6.0, 11.0)), match_held_up_s=lambda: next(stood, 7.0 + stood_s))
    opened.begin()
    opened.wait_was(120.0)
    assert opened.charged_s == pytest.approx(charged_s)


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells")
def test_the_system_tells_for_how_long_this_thread_waited_for_a_processor() -> None:
    """Two threads in a loop on one processor stand in each other's way; one that sleeps in nobody's."""
    usage = tasks.usage_of(os.getpid())
    if usage is None or usage.held_up_s is None:
        pytest.skip("this kernel does not count it")
    told: list[float] = []

    def computes() -> None:
        before_s = tasks.held_up_here_s()
        end_s = time.monotonic() + 60
        while tasks.held_up_here_s() - before_s < 0.01 and time.monotonic() < end_s:
            hashlib.sha256(bytes(100_000))
        told.append(tasks.held_up_here_s() - before_s)

    allowed = os.sched_getaffinity(0)
    os.sched_setaffinity(0, {min(allowed)})
    try:
        threads = [threading.Thread(target=computes) for _ in range(2)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
    finally:
        os.sched_setaffinity(0, allowed)
    assert max(told) >= 0.01


def test_who_was_held_up_is_waited_for_until_the_rest_is_used_up() -> None:
    opened = account(41.0, 80.0, 100.0)
    assert opened.limit_s == HALF_S
    assert opened.may_go_on(20.0)
    assert opened.limit_s == pytest.approx(120.0 + HALF_S - 41.0)


def test_who_computed_or_slept_all_the_time_is_not() -> None:
    assert not account(120.0, 5.0, 119.0).may_go_on(1.0)
    assert not account(0.1, 0.1, 119.0).may_go_on(1.2)


def test_where_nothing_can_be_told_the_whole_wait_is_charged() -> None:
    opened = Account(HALF_S, lambda: None)
    opened.begin()
    opened.wait_was(3.0)
    opened.wait_was(1.0)
    assert (opened.charged_s, opened.waited_s, opened.slowest_s) == (4.0, 4.0, 3.0)


def test_what_comes_after_the_account_is_closed_is_free() -> None:
    opened = account(1.0, 0.0, 1.0)
    opened.close()
    opened.wait_was(1.0)
    assert opened.charged_s == 1.0


@pytest.mark.skipif(sys.platform == "win32", reason="there the job object tells")
def test_the_system_tells_what_a_process_computed() -> None:
    before = tasks.usage_of(os.getpid())
    began_s = time.process_time()
    while time.process_time() - began_s < 0.02:
        pass
    after = tasks.usage_of(os.getpid())
    assert before is not None
    assert after is not None
    assert after.computed_s - before.computed_s >= (0.02 if sys.platform == "linux" else 0.0)


@pytest.mark.skipif(sys.platform == "win32", reason="there the job object tells")
def test_of_a_process_that_is_gone_nothing_is_told() -> None:
    assert tasks.usage_of(2**22 + 1) is None


@pytest.mark.parametrize(
    ("told", "seconds"), [("  0:01.25\n", 1.25), ("00:01:02", 62.0), ("2-03:04:05", 183_845.0), ("90:00.00", 5400.0)]
)
def test_times_of_ps_are_read(told: str, seconds: float) -> None:
    assert tasks.seconds_of(told) == seconds


def test_a_program_that_others_held_up_is_not_stopped_by_the_sum(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(Process, "usage", lambda _: Usage(0.0, time.perf_counter()))
    assert FakeMatch(tmp_path, half_s=0.1).play("faults/slow_on_every_step", 6).fault is None
