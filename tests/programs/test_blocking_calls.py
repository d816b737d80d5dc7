"""Programs that wait with a limit: it passes on the simulated clock, and costs real time only where others may come."""

from __future__ import annotations

import sys
from collections.abc import Callable
from importlib.util import module_from_spec
from pathlib import Path
from types import SimpleNamespace

import pytest
from fake_match import FakeMatch

from rcj_challenges.programs.program_side.controller import _blocking_calls
from rcj_challenges.programs.program_side.controller._blocking_calls import BlockingCalls
from rcj_challenges.programs.program_side.controller._clock import Clock
from rcj_challenges.programs.program_side.controller._hooks import AfterImport

ROBOT = "from controller import Robot\nrobot = Robot()\nrobot.step(32)\n"
STEPS = "\nrobot.step(32)\nrobot.step(32)\n"
AN_HOUR = 3600 * 1000 // 32  # ticks

WAITS = {
    "an event": "import threading\nthreading.Event().wait({s})",
    "a condition": "import threading\ncondition = threading.Condition()\n"
    "with condition:\n    print(condition.wait_for(lambda: False, timeout={s}))",
    "a queue": "import queue\ntry:\n    queue.Queue().get(timeout={s})\nexcept queue.Empty:\n    print(False)",
    "a semaphore": "import threading\nprint(threading.Semaphore(0).acquire(timeout={s}))",
    "results": "import concurrent.futures as c\ntry:\n    list(c.as_completed([c.Future()], timeout={s}))\n"
    "except TimeoutError:\n    print(False)",
    "a simple queue": "import queue\ntry:\n    queue.SimpleQueue().get(timeout={s})\nexcept queue.Empty:\n"
    "    print(False)",
    "a simple queue, the timeout by its place": "import queue\ntry:\n    queue.SimpleQueue().get(True, {s})\n"
    "except queue.Empty:\n    print(False)",
    "nothing at all": "import select\nprint(any(select.select([], [], [], {s})))",
    "files": "import selectors\nprint(bool(selectors.DefaultSelector().select({s})))",
    "files, plainly": "import selectors\nprint(bool(selectors.SelectSelector().select({s})))",
    "asyncio's clock": "import asyncio\nasyncio.run(asyncio.sleep({s}))",
    "an event of asyncio": "import asyncio\n"
    "async def wait():\n"
    "    try:\n        await asyncio.wait_for(asyncio.Event().wait(), {s})\n"
    "    except asyncio.TimeoutError:\n        print(False)\n"
    "asyncio.run(wait())",
}
if sys.platform == "win32":
    for name in ("nothing at all", "files", "files, plainly"):
        del WAITS[name]  # there one takes sockets only, and at least one


@pytest.mark.parametrize("what", WAITS)
def test_a_program_that_waits_in_vain_misses_ticks_as_one_that_sleeps(match: FakeMatch, what: str) -> None:
    played = match.play(ROBOT + WAITS[what].format(s=0.2) + STEPS, 9)
    assert played.fault is None
    assert [(tick, r.missed_ticks) for tick, r in played.requests] == [(0, 0), (1, 6), (8, 0)]
    assert "True" not in played.said


def test_a_wait_that_no_other_thread_could_end_takes_no_real_time(match: FakeMatch) -> None:
    """An hour is far longer than a step may take."""
    waits = [wait.format(s=3600) + "\nrobot.step(32)\n" for wait in WAITS.values()]
    played = match.play(ROBOT + "".join(waits) + STEPS, len(WAITS) * (AN_HOUR + 1) + 4)
    missed = [r.missed_ticks for _, r in played.requests]
    assert dict(zip(WAITS, missed[1:], strict=False)) == dict.fromkeys(WAITS, AN_HOUR)
    assert [missed[0], *missed[len(WAITS) + 1 :]] == [0, 0, 0]


def test_what_another_thread_brings_in_time_costs_no_ticks(match: FakeMatch) -> None:
    program = """
import asyncio, queue, threading, time
box, event = queue.Queue(), threading.Event()
threading.Thread(target=lambda: (time.sleep(0.05), box.put("brought"), time.sleep(0.05), event.set())).start()
print(box.get(timeout=60), event.wait(60))
async def ask():
    return await asyncio.wait_for(asyncio.to_thread(lambda: (time.sleep(0.05), "computed")[1]), 60)
print(asyncio.run(ask()))
"""
    played = match.play(ROBOT + program + STEPS, 3)
    assert played.said == ["brought True", "computed"]
    assert [r.missed_ticks for _, r in played.requests] == [0, 0, 0]


def test_a_thread_that_ends_in_time_is_joined_at_once(match: FakeMatch) -> None:
    program = """
import threading, time
thread = threading.Thread(target=lambda: time.sleep(0.05))
thread.start()
print(thread.join(60), thread.is_alive())
try:
    threading.current_thread().join(1)
except RuntimeError as error:
    print(error)
"""
    played = match.play(ROBOT + program + STEPS, 3)
    assert played.said == ["None False", "cannot join current thread"]
    assert [r.missed_ticks for _, r in played.requests] == [0, 0, 0]


def test_tasks_of_asyncio_take_turns_while_the_robot_drives(match: FakeMatch) -> None:
    program = """
import asyncio
from controller import Robot
robot = Robot()
async def look():
    while True:
        print("look", round(robot.getTime(), 3))
        await asyncio.sleep(0.064)
async def drive():
    while robot.step(32) != -1:
        await asyncio.sleep(0.001)
async def main():
    looking = asyncio.create_task(look())
    await drive()
    looking.cancel()
asyncio.run(main())
"""
    played = match.play(program, 6)
    assert played.fault is None
    assert [r.missed_ticks for _, r in played.requests] == [0] * 6
    assert len(played.said) >= 2


def test_the_waits_of_asyncio_on_windows_pass_in_the_same_way() -> None:
    """The module exists on Windows only: here one of the same form."""

    class IocpProactor:
        waited = 0.0

        def select(self, timeout: float | None = None) -> list[object]:
            self.waited += timeout or 0
            return []

    clock = Clock(32_000_000)
    BlockingCalls(clock).patches()["asyncio.windows_events"](SimpleNamespace(IocpProactor=IocpProactor))
    proactor = IocpProactor()
    assert proactor.select(1.0) == []
    assert (clock.missed_ticks(), proactor.waited) == (31, 0.0)


A_THREAD = """
import threading
thread = threading.Thread(target=threading.Event().wait, daemon=True)
thread.start()
"""
WAITS_BESIDE_A_THREAD = {
    "alone, asyncio": "import asyncio\nasyncio.run(asyncio.sleep({s}))",
    **{what: A_THREAD + wait for what, wait in WAITS.items()},
    "the end of a thread": A_THREAD + "thread.join({s})\n",
}


def test_a_wait_takes_its_time_once_with_other_threads_and_without(either_match: FakeMatch) -> None:
    """Also where a thread of ours watches over the process."""
    waits = [wait.format(s=0.1) + "\nrobot.step(32)\n" for wait in WAITS_BESIDE_A_THREAD.values()]
    played = either_match.play(ROBOT + "".join(waits) + STEPS, 4 * len(waits) + 4)
    missed = [r.missed_ticks for _, r in played.requests]
    assert dict(zip(WAITS_BESIDE_A_THREAD, missed[1:], strict=False)) == dict.fromkeys(WAITS_BESIDE_A_THREAD, 3)
    assert [missed[0], *missed[len(waits) + 1 :]] == [0, 0, 0]


def test_a_thread_of_ours_is_none_that_could_end_a_wait(tmp_path: Path) -> None:
    """An hour of waiting is over at once, as without that thread."""
    program = "import threading\nthreading.Event().wait(3600)"
    played = FakeMatch(tmp_path, portable=True).play(ROBOT + program + STEPS, AN_HOUR + 3)
    assert [r.missed_ticks for _, r in played.requests] == [0, AN_HOUR, 0]


BESIDE = """
import queue, threading
work, answers = queue.Queue(), queue.Queue()
def worker():
    while True:
        answers.put(sum(range(work.get())))
threading.Thread(target=worker, daemon=True).start()
"""


@pytest.mark.skipif(sys.platform == "win32", reason="the processor time of a process is too coarse")
@pytest.mark.nightly
def test_short_waits_beside_a_thread_that_waits_itself_do_not_use_up_the_half(tmp_path: Path) -> None:
    """Ten thousandths of a second in each of 700 steps would be seven seconds."""
    program = BESIDE + "while robot.step(32) != -1:\n    try: answers.get(timeout=0.01)\n    except queue.Empty: pass\n"
    played = FakeMatch(tmp_path, half_s=5).play(ROBOT + program, 700)
    assert played.fault is None
    assert [r.missed_ticks for _, r in played.requests] == [0] * 700


@pytest.mark.skipif(sys.platform == "win32", reason="there a short wait is simply waited for")
class TestAShortWait:
    """It is made of looks whether what is waited for has come."""

    @staticmethod
    def waited(
        monkeypatch: pytest.MonkeyPatch,
        would_run: Callable[[int], bool | None],
        look_s: float,
        computed_s: float = 0.0,
        comes_at: int = 0,
    ) -> tuple[bool, int]:
        """Wait for 0.031 s; returns whether it came, and after how many looks.

        Args:
            monkeypatch: of the test.
            would_run: whether others would run, as the system tells it after so many looks; None: it does not tell.
            look_s: how long each look takes.
            computed_s: for how long the program computes meanwhile.
            comes_at: the look by which it comes; 0: never.
        """
        seen = SimpleNamespace(real_s=0.0, computed_s=0.0, looks=0)
        monkeypatch.setattr(_blocking_calls, "real_monotonic", lambda: seen.real_s)
        monkeypatch.setattr(_blocking_calls, "real_process_time", lambda: seen.computed_s)
        monkeypatch.setattr(_blocking_calls, "others_would_run", lambda: would_run(seen.looks))

        def look(_: object, timeout: float) -> bool:
            assert timeout == 0.001
            seen.looks += 1
            seen.real_s += look_s
            seen.computed_s += computed_s
            return seen.looks == comes_at

        return bool(_blocking_calls._for_others(look, None, 0.031)), seen.looks

    def test_goes_on_while_others_have_the_processor_where_the_system_does_not_list_runnable_threads(
        self, monkeypatch
    ) -> None:
        """Each look takes 0.2 s in which this program computed for 0.001 s."""
        assert self.waited(monkeypatch, lambda _: None, 0.2, 0.001, comes_at=10) == (True, 10)
        came, looks = self.waited(monkeypatch, lambda _: None, 0.2, 0.001)
        assert not came
        assert 15 <= looks <= 31

    def test_goes_on_while_another_thread_has_not_had_the_processor_yet(self, monkeypatch) -> None:
        """For three looks another process has it, and no thread computes."""
        assert self.waited(monkeypatch, lambda looks: looks <= 3, 0.001) == (False, 4)

    def test_does_not_count_the_time_in_which_another_thread_would_run_and_has_no_processor(self, monkeypatch) -> None:
        """On a busy machine the waiting thread is woken every 0.001 s, while the thread that is waited for gets nothing."""
        assert self.waited(monkeypatch, lambda _: True, 0.001, comes_at=300) == (True, 300)

    def test_is_over_as_soon_on_a_busy_machine_where_no_other_thread_would_run(self, monkeypatch) -> None:
        """Each look takes 0.2 s, as others have the processor: waited for to its end, it would use up the half."""
        assert self.waited(monkeypatch, lambda _: False, 0.2) == (False, 1)


def test_the_wait_of_one_thread_changes_nothing_about_those_of_the_one_that_steps_meanwhile(match: FakeMatch) -> None:
    """The main thread has stepped last when it begins to wait; only then the other one begins to step."""
    program = """
import threading
def play():
    sum(range(5_000_000))
    robot.step(32)
    threading.Event().wait(0.32)
    while robot.step(32) != -1:
        pass
thread = threading.Thread(target=play)
thread.start()
thread.join(30)
"""
    played = match.play(ROBOT + program, 15)
    assert [r.missed_ticks for _, r in played.requests][:4] == [0, 0, 10, 0]


def test_modules_that_are_built_into_the_interpreter_are_patched_too() -> None:
    """Which these are differs: in some distributions of Python, `select` is one."""
    seen = []
    spec = AfterImport({"_tokenize": seen.append}, "/nowhere").find_spec("_tokenize")
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    assert seen == [module]
