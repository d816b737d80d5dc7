"""A program is roused before it is told what its step brought: it wakes up while the match still works that out."""

from __future__ import annotations

import os
import sys
import threading
import time
from collections.abc import Iterator
from types import SimpleNamespace

import pytest
from fake_match import SPEC as SPEC_OF_Y1
from fake_match import FakeMatch, Played, values_at
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.controllers import pipes, tasks
from rcj_challenges.controllers.processes import PUPIL_FOLDER
from rcj_challenges.controllers.program import Program
from rcj_challenges.facts.play import Fault
from rcj_challenges.facts.traffic import Observation

sys.path.append(str(PUPIL_FOLDER))
from controller import _wire  # type: ignore[import-not-found]  # the program's end, as programs import it

ROUSED = bytes(4)
POSIX = pytest.mark.skipif(sys.platform == "win32", reason="pipes cannot be polled on Windows")


def framed(body: bytes) -> bytes:
    return len(body).to_bytes(4, "little") + body


class Line:
    """The program's end of the pipes, and what the match would have."""

    def __init__(self) -> None:
        self._read, self.says = os.pipe()
        self.hears, self._write = os.pipe()
        self.wire = _wire.Wire(self._read, self._write)
        self.wire.count_our_threads()

    def tell(self, data: bytes) -> None:
        os.write(self.says, data)

    def close(self) -> None:
        for fd in (self._read, self.says, self.hears, self._write):
            os.close(fd)


@pytest.fixture
def line() -> Iterator[Line]:
    opened = Line()
    yield opened
    opened.close()


@pytest.fixture
def left(monkeypatch: pytest.MonkeyPatch) -> None:
    """A program that would end at once raises instead."""

    def leave(status: int) -> None:
        raise SystemExit(status)

    monkeypatch.setattr(_wire, "leave", leave)


class TestTheProgramsEnd:
    """It passes over an empty frame, and hands out the one that follows."""

    def test_whatever_follows_is_what_a_step_brings(self, line: Line) -> None:
        line.tell(ROUSED + framed(b"tick 1"))
        assert line.wire.exchange(framed(b"go on")) == framed(b"tick 1")
        line.tell(framed(b"tick 2"))
        assert line.wire.exchange(framed(b"go on")) == framed(b"tick 2")

    @POSIX
    def test_it_looks_for_what_follows_without_sleeping(self, line: Line, monkeypatch: pytest.MonkeyPatch) -> None:
        moments_s = iter(range(100))
        monkeypatch.setattr(_wire, "_AT_ONCE_S", 50)
        monkeypatch.setattr(_wire, "perf_counter", lambda: next(moments_s))
        looks: list[int] = []

        def let_others_run() -> None:
            looks.append(0)
            if len(looks) == 3:
                line.tell(framed(b"tick 1"))

        monkeypatch.setattr(_wire, "_let_others_run", let_others_run)
        line.tell(ROUSED)
        assert line.wire.exchange(framed(b"go on")) == framed(b"tick 1")
        assert len(looks) == 3

    def test_what_takes_longer_is_slept_for(self, line: Line) -> None:
        line.tell(ROUSED)
        threading.Timer(0.05, line.tell, [framed(b"late")]).start()
        assert line.wire.exchange(framed(b"go on")) == framed(b"late")

    @POSIX
    def test_beside_threads_of_the_program_it_sleeps_at_once(self, line: Line, monkeypatch: pytest.MonkeyPatch) -> None:
        monkeypatch.setattr(_wire, "_count", lambda: 99)
        monkeypatch.setattr(_wire, "_let_others_run", lambda: pytest.fail("it looked, and held up the threads"))
        line.tell(ROUSED)
        threading.Timer(0.05, line.tell, [framed(b"tick 1")]).start()
        assert line.wire.exchange(framed(b"go on")) == framed(b"tick 1")

    def test_also_before_its_first_step_and_after_a_large_request(self, line: Line) -> None:
        line.tell(ROUSED + framed(b"hello"))
        assert line.wire.receive() == framed(b"hello")
        line.tell(ROUSED + framed(b"tick 1"))
        assert line.wire.exchange(framed(bytes(2000))) == framed(b"tick 1")

    @given(st.integers(1, 20_000), st.booleans())
    def test_an_observation_of_any_size_arrives_whole(self, size: int, is_apart: bool) -> None:
        line, frame = Line(), framed(bytes(size))
        try:
            parts = [ROUSED, frame] if is_apart else [ROUSED + frame]
            teller = threading.Thread(target=lambda: [line.tell(part) for part in parts])
            teller.start()
            assert line.wire.exchange(framed(b"go on")) == frame
            teller.join()
        finally:
            line.close()

    @pytest.mark.usefixtures("left")
    def test_it_ends_if_nobody_is_there_any_more(self) -> None:
        line = Line()
        line.tell(ROUSED)
        os.close(line.says)
        with pytest.raises(SystemExit):
            line.wire.exchange(framed(b"go on"))
        line.says = os.dup(0)
        line.close()


@POSIX
class TestTheMatchsEnd:
    """`Channel.rouse` of pipes that can be polled."""

    @pytest.fixture
    def ends(self) -> Iterator[tuple[pipes.Channel, int, int]]:
        read_fd, their_write = os.pipe()
        their_read, write_fd = os.pipe()
        channel = pipes.open_channel(read_fd, write_fd, 1000, portable=False)
        yield channel, their_read, their_write
        channel.close()
        for fd in (their_read, their_write):
            os.close(fd)

    def test_the_other_side_reads_an_empty_frame_and_then_what_it_is_told(
        self, ends: tuple[pipes.Channel, int, int]
    ) -> None:
        channel, their_read, _ = ends
        channel.rouse()
        channel.send(framed(b"tick 1"))
        assert os.read(their_read, 100) == ROUSED + framed(b"tick 1")

    def test_one_that_does_not_read_is_not_waited_for(self, ends: tuple[pipes.Channel, int, int]) -> None:
        channel, _, _ = ends
        for _ in range(100_000):
            channel.rouse()
        channel.send(framed(bytes(500)))
        channel.rouse()  # something is unsent: an empty frame would come in the middle of it
        assert channel.receive_now() is None

    def test_one_that_is_gone_shows_at_the_next_look(self) -> None:
        read_fd, their_write = os.pipe()
        their_read, write_fd = os.pipe()
        channel = pipes.open_channel(read_fd, write_fd, 1000, portable=False)
        os.close(their_read)
        os.close(their_write)
        channel.rouse()
        with pytest.raises(pipes.ChannelClosedError):
            channel.receive(1)
        channel.close()


def test_where_pipes_have_threads_nobody_is_roused() -> None:
    read_fd, their_write = os.pipe()
    their_read, write_fd = os.pipe()
    channel = pipes.open_channel(read_fd, write_fd, 1000, portable=True)
    channel.rouse()
    channel.send(framed(b"tick 1"))
    assert os.read(their_read, 100) == framed(b"tick 1")
    os.close(their_write)
    os.close(their_read)
    channel.close()


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells what runs")
class TestSleepers:
    """Only where a processor sleeps somebody has to be roused; elsewhere it would take the time of others."""

    @pytest.fixture
    def running(self, monkeypatch: pytest.MonkeyPatch) -> SimpleNamespace:
        told = SimpleNamespace(threads=1, asked=0)

        def ask() -> int:
            told.asked += 1
            return int(told.threads)

        monkeypatch.setattr(tasks, "_running", ask)
        monkeypatch.setattr(os, "sched_getaffinity", lambda _: {0, 1})
        return told

    @pytest.mark.parametrize(("threads", "there_are"), [(1, True), (2, False), (9, False), (0, False)])
    def test_there_are_some_if_fewer_threads_run_than_there_are_processors(
        self, running: SimpleNamespace, threads: int, there_are: bool
    ) -> None:
        running.threads = threads
        assert tasks.Sleepers().there_are() is there_are

    def test_the_system_is_asked_every_16th_time(self, running: SimpleNamespace) -> None:
        sleepers = tasks.Sleepers()
        assert all(sleepers.there_are() for _ in range(16))
        running.threads = 2
        assert not any(sleepers.there_are() for _ in range(17))
        assert running.asked == 3

    def test_this_system_tells_that_this_thread_runs(self) -> None:
        assert tasks._running() >= 1


def roused_and_released(program: Program, ticks: int) -> list[Fault | None]:
    """Play as a match does: rouse, work something out, release, collect."""
    answers = [program.collect()]
    for tick in range(1, ticks + 1):
        program.rouse()
        if tick % 7 == 0:
            time.sleep(0.001)  # longer than it looks
        program.release(Observation(tick, values_at(tick), []))
        answers.append(program.collect())
    return [answer if isinstance(answer, Fault) else None for answer in answers]


READS_ITS_GPS = """from controller import Robot
robot = Robot()
gps = robot.getDevice("gps")
gps.enable(32)
while robot.step(32) != -1:
    print(int(gps.getValues()[0]))
"""


@pytest.mark.parametrize(
    "beside", ["", "import threading, time\nthreading.Thread(target=time.sleep, args=(9,)).start()\n"]
)
def test_a_real_program_is_told_all_ticks_and_its_end(
    match: FakeMatch, monkeypatch: pytest.MonkeyPatch, beside: str
) -> None:
    monkeypatch.setattr(tasks.Sleepers, "there_are", lambda _: True)
    team, played = match.team(beside + READS_ITS_GPS), Played()
    with match.crew() as crew:
        program = crew.add(SPEC_OF_Y1, team, team.entry_for("Y1", "robot.py"))
        crew.launch()
        assert not any(roused_and_released(program, 60))
        program.rouse()  # and then the half ends
        crew.finish({"Y1": Observation(60, values_at(60), [], over=True)})
        crew.close()
        played.log = program.new_output()
    assert played.said == [str(tick) for tick in range(1, 61)]
