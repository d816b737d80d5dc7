"""Programs with threads of their own: their waits follow the match, and the one that steps may be any of them."""

from __future__ import annotations

import time

import pytest
from fake_match import INDEX, FakeMatch, Played

SECOND = 1000 // 32  # ticks


def numbers_of(played: Played) -> list[float]:
    """What the program printed last, one number each."""
    assert played.fault is None
    return [float(word) for word in played.said[-1].split()]


BESIDE = """
import threading, time
from controller import Robot
robot = Robot()
seen = []
def look():
    while True:
        {wait}
        seen.append(robot.getTime())
{start}
while robot.step(32) != -1:
    sum(range(20_000))  # a robot thinks
print(*seen)
"""


@pytest.mark.parametrize("wait", ["time.sleep(0.32)", "threading.Event().wait(0.32)"])
def test_a_thread_beside_the_one_that_steps_waits_for_the_time_of_the_match(match: FakeMatch, wait: str) -> None:
    """Ten seconds of the match take a fraction of a second here: a thread that really waited would not come round."""
    start = "threading.Thread(target=look, daemon=True).start()"
    seen = numbers_of(match.play(BESIDE.format(wait=wait, start=start), 10 * SECOND))
    assert 5 <= len(seen) <= 31  # fewer where others take the processor: the match does not wait for this thread
    assert seen[0] >= 0.32


def test_a_timer_fires_when_the_match_has_come_so_far(match: FakeMatch) -> None:
    start = "timer = threading.Timer(2.0, lambda: seen.append(robot.getTime()))\ntimer.daemon = True\ntimer.start()"
    (fired_s,) = numbers_of(match.play(BESIDE.format(wait="pass", start=start), 10 * SECOND))
    # Ten seconds of the match take a fraction of a second here: it would not fire in them if it really waited. Later
    # where others take the processor: the match does not wait for this thread.
    assert fired_s >= 2.0


def test_waits_beside_a_standstill_pass_in_real_time(match: FakeMatch) -> None:
    """The robot waits for its thread, so no tick begins; the thread goes on all the same."""
    program = """
import threading, time
from controller import Robot
robot = Robot()
robot.step(32)
def prepare():
    for _ in range(3): time.sleep(0.05)
thread = threading.Thread(target=prepare)
thread.start()
thread.join()
print("prepared")
robot.step(32)
"""
    played = match.play(program, 2)
    assert played.said == ["prepared"]
    assert [r.missed_ticks for _, r in played.requests] == [0, 0]


DRIVEN_BY_A_THREAD = """
import threading, time
from controller import Robot
running = True
def drive():
    global running
    sum(range(5_000_000))  # it prepares something first
    robot = Robot()
    while robot.step(32) != -1: pass
    running = False
threading.Thread(target=drive).start()
while running:
    {wait}
"""


@pytest.mark.parametrize("wait", ["time.sleep(0.1)", "threading.Event().wait(0.1)"])
def test_while_a_thread_prepares_to_drive_the_main_one_may_sleep_and_misses_nothing(
    match: FakeMatch, wait: str
) -> None:
    played = match.play(DRIVEN_BY_A_THREAD.format(wait=wait), 20)
    assert played.fault is None
    assert [(tick, r.missed_ticks) for tick, r in played.requests] == [(tick, 0) for tick in range(20)]


def test_a_pool_of_threads_that_is_not_shut_down_does_not_keep_a_program_from_its_end(match: FakeMatch) -> None:
    program = """
from concurrent.futures import ThreadPoolExecutor
from controller import Robot
robot = Robot()
pool = ThreadPoolExecutor(2)
for n in range(3):
    assert pool.submit(lambda: n).result() == n
    robot.step(32)
"""
    began_s = time.perf_counter()
    played = match.play(program, 10)
    assert played.fault is not None
    assert (played.fault.kind, played.fault.tick) == ("exit", 3)
    assert time.perf_counter() - began_s < match.limits.step_s


STEPPED_BY_A_THREAD = """
import threading, time
from controller import Robot
robot = Robot()
motor, emitter, gps = (robot.getDevice(name) for name in ("left wheel motor", "team emitter", "gps"))
motor.setPosition(float("inf"))
motor.setVelocity(0)
running = True
def drive():
    global running
    while robot.step(32) != -1: pass
    running = False
threading.Thread(target=drive).start()
"""


def test_what_is_set_while_another_thread_steps_acts_in_the_next_step(match: FakeMatch) -> None:
    """As in the original: what one thread sets is kept until the other one steps again."""
    program = STEPPED_BY_A_THREAD.replace(
        "running = True\n",
        """running = True
from controller import _connection
wire = _connection.connected()._wire
real, settings = wire.exchange, iter([
    lambda: motor.setVelocity(3), lambda: emitter.send(b"now"), lambda: gps.enable(64), lambda: motor.setAcceleration(1),
    lambda: motor.setVelocity(5),
])
def exchange(frame):
    other = threading.Thread(target=next(settings, int))
    other.start()
    other.join()
    return real(frame)
wire.exchange = exchange
""",
    )
    played = match.play(program, 9)
    assert played.fault is None
    requests = [request for _, request in played.requests]
    assert [m.velocity_radps for m in requests[1].motors] == [3.0]
    assert requests[2].emissions == ((INDEX["team emitter"], 3, b"now"),)
    assert requests[3].sampling == ((INDEX["gps"], 2),)
    assert [m.velocity_radps for m in requests[5].motors] == [pytest.approx(3.032)]


def test_a_main_thread_may_drive_while_another_one_steps(match: FakeMatch) -> None:
    # On a busy machine the main thread may have no processor for a while, in which the other one steps on.
    played = match.play(
        STEPPED_BY_A_THREAD + "time.sleep(0.1)\nmotor.setVelocity(7)\nwhile running: time.sleep(0.1)\n", 60 * SECOND
    )
    assert played.fault is None
    assert [velocity for _, velocity, _ in played.motors()] == [0.0, 7.0]


def test_after_a_thread_that_stepped_has_ended_time_is_the_main_threads_again(match: FakeMatch) -> None:
    """It would wait for a match that waits for it: no other thread is left to step."""
    program = """
import threading, time
from controller import Robot
robot = Robot()
def turn():
    for _ in range(3):
        robot.step(32)
thread = threading.Thread(target=turn)
thread.start()
thread.join()
began_s = time.time()
while time.time() - began_s < 0.1:
    pass
time.sleep(0.064)
while robot.step(32) != -1:
    pass
"""
    played = match.play(program, 12)
    assert played.fault is None
    assert [(tick, r.missed_ticks) for tick, r in played.requests][:4] == [(0, 0), (1, 0), (2, 0), (3, 5)]


def test_a_thread_that_computes_for_ever_hands_over_soon(match: FakeMatch) -> None:
    """The one that steps waits for it twice in a step: with Python's own 5 ms a half is too short."""
    program = """
import sys, threading
from controller import Robot
robot = Robot()
def think():
    while True:
        sum(i * i for i in range(1000))
threading.Thread(target=think, daemon=True).start()
while robot.step(32) != -1:
    pass
print(sys.getswitchinterval())
"""
    (interval_s,) = numbers_of(match.play(program, 20))
    assert 2 * interval_s <= 0.001


def test_a_pool_of_threads_works_where_processes_are_refused(match: FakeMatch) -> None:
    program = """
from controller import Robot
from multiprocessing.dummy import Pool
from multiprocessing.pool import ThreadPool
robot = Robot()
with ThreadPool(2) as pool:
    print(pool.map(abs, [-1, 2, -3]), pool.apply_async(pow, (2, 5)).get(timeout=5))
helpers = Pool(2)
later = helpers.map_async(len, ["a", "bc"])
robot.step(32)
print(later.get())
helpers.close()
helpers.join()
robot.step(32)
"""
    assert match.play(program, 2).said == ["[1, 2, 3] 32", "[1, 2]"]


def test_threads_that_step_together_take_turns(either_match: FakeMatch) -> None:
    """As in the original, where one waits for the step of the other."""
    program = """
import threading
from controller import Robot, _connection
robot = Robot()
wire = _connection.connected()._wire
real, inside, together = wire.exchange, [], []
def exchange(frame):
    inside.append(threading.get_ident())
    together.append(len(inside))
    answer = real(frame)
    inside.pop()
    return answer
wire.exchange = exchange
stepped = []
def drive():
    steps = 0
    while robot.step(32) != -1:
        steps += 1
    stepped.append(steps)
other = threading.Thread(target=drive)
other.start()
drive()
other.join()
print(sum(stepped), set(together))
"""
    played = either_match.play(program, ticks=60)
    assert played.fault is None
    assert [tick for tick, _ in played.requests] == list(range(60))
    assert played.said == ["59 {1}"]
