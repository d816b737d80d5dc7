"""Radio packets that a program does not read: they wait in a bounded queue."""

from __future__ import annotations

import sys
import threading
from collections import deque

from fake_match import FakeMatch, packet

from rcj_challenges.programs.processes import PROGRAM_SIDE

sys.path.insert(0, str(PROGRAM_SIDE))  # before the package of the same name that editors read
from controller import _connection  # type: ignore[import-not-found]  # the program's end, as programs import it


def test_a_queue_that_is_never_popped_drops_the_oldest_beyond_its_bound(match: FakeMatch) -> None:
    program = """
from controller import Robot
robot = Robot()
team = robot.getDevice("team receiver")
team.enable(32)
while robot.step(32) != -1:
    pass
print(team.getQueueLength(), team.getBytes()[:2])
"""
    played = match.play(program, 30, lambda tick: [packet("team receiver", b"%02d" % tick + bytes(999_998))])
    # 16 MiB hold 16 packets of a megabyte.
    assert played.said == ["16 b'14'"]


def test_many_small_packets_that_are_never_popped_are_dropped_too(match: FakeMatch) -> None:
    program = """
import controller, sys
connection = sys.modules["controller._connection"]
connection.QUEUE_BYTES = 300_000
robot = controller.Robot()
team = robot.getDevice("team receiver")
team.enable(32)
most = 0
while robot.step(32) != -1:
    most = max(most, team.getQueueLength())
print(most, team.getQueueLength(), team.getBytes())
"""
    # 5 of them are on the wire 195 bytes and more, and take 1005 bytes of a queue; trimmed in each 512 KiB that come.
    played = match.play(program, 4000, lambda tick: [packet("team receiver", b"%d" % (tick % 10))] * 5)
    most, left, first = played.said[0].split()
    assert 1_400 < int(most) < 1_500 + 5 * 2_700
    assert int(left) < int(most)
    assert len(first) == len("b'1'")


def test_a_queue_is_trimmed_while_another_thread_reads_it() -> None:
    queue, ended, interval_s = deque(), threading.Event(), sys.getswitchinterval()

    def read() -> None:
        while not ended.is_set():
            if queue:
                queue.popleft()

    reader = threading.Thread(target=read)
    sys.setswitchinterval(1e-5)
    try:
        reader.start()
        for _ in range(200):
            queue.extend([(b"1", 1.0, 1.0, 0.0, 0.0)] * 3_000)
            _connection.trim(queue)
    finally:
        sys.setswitchinterval(interval_s)
        ended.set()
        reader.join()
