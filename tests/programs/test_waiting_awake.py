"""A program whose next observation follows soon waits for it awake, if no other program is harmed."""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
from fake_match import SPEC, FakeMatch, Played, values_at
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.programs.cpu_policy import DEFAULT_SHARE, CpuShare, current_cpu
from rcj_challenges.programs.processes import PROGRAM_SIDE
from rcj_challenges.core.play import Fault
from rcj_challenges.core.traffic import Observation

sys.path.insert(0, str(PROGRAM_SIDE))  # before the package of the same name that editors read
from controller import _wire  # type: ignore[import-not-found]  # the program's end, as programs import it

POSIX = pytest.mark.skipif(sys.platform == "win32", reason="pipes cannot be polled on Windows")
GO_ON = b"\x05\0\0\0go on"


def framed(body: bytes) -> bytes:
    return len(body).to_bytes(4, "little") + body


class Line:
    """The program's end of the pipes, set to stay awake, and the match's ends."""

    def __init__(self) -> None:
        self._read, self._says = os.pipe()
        self._hears, self._write = os.pipe()
        self.wire = _wire.Wire(self._read, self._write)
        self.wire.count_our_threads()
        self.wire.next_is_soon = True

    def tell(self, data: bytes) -> None:
        while data:
            data = data[os.write(self._says, data) :]

    def hang_up(self) -> None:
        os.close(self._says)
        self._says = -1

    def close(self) -> None:
        for fd in (self._read, self._says, self._hears, self._write):
            if fd >= 0:
                os.close(fd)


@pytest.fixture
def line() -> Iterator[Line]:
    opened = Line()
    yield opened
    opened.close()


@POSIX
def test_waiting_polls_repeatedly_and_yields_to_other_processes(line: Line, monkeypatch: pytest.MonkeyPatch) -> None:
    looks: list[int] = []

    def let_others_run() -> None:
        looks.append(0)
        if len(looks) == 3:
            line.tell(framed(b"tick 1"))

    monkeypatch.setattr(_wire, "_AWAKE_S", 60.0)
    monkeypatch.setattr(_wire, "_let_others_run", let_others_run)
    assert line.wire.exchange(GO_ON) == framed(b"tick 1")
    assert len(looks) == 3


@POSIX
def test_it_does_not_look_for_long(line: Line, monkeypatch: pytest.MonkeyPatch) -> None:
    moments_s = iter([0.0, 0.0004, 0.0008, 0.0012])
    looks: list[int] = []
    monkeypatch.setattr(_wire, "perf_counter", lambda: next(moments_s))
    monkeypatch.setattr(_wire, "_count", lambda: 0)  # that of this test is none of the program's
    monkeypatch.setattr(_wire, "_let_others_run", lambda: looks.append(0))
    threading.Timer(0.05, line.tell, [framed(b"late")]).start()
    assert line.wire.exchange(GO_ON) == framed(b"late")
    assert len(looks) == 2


@pytest.mark.parametrize("why", ["not requested", "threads of the program"])
def test_otherwise_it_sleeps(line: Line, monkeypatch: pytest.MonkeyPatch, why: str) -> None:
    if why == "not requested":
        line.wire.next_is_soon = False
    else:
        monkeypatch.setattr(_wire, "_count", lambda: 99)  # each look would hold them up
    monkeypatch.setattr(_wire, "_let_others_run", lambda: pytest.fail("it looked"))
    threading.Timer(0.05, line.tell, [framed(b"tick 1")]).start()
    assert line.wire.exchange(GO_ON) == framed(b"tick 1")


@given(st.integers(1, 100_000))
def test_an_observation_of_any_size_arrives_whole(size: int) -> None:
    line, frame = Line(), framed(bytes(size))
    line.wire._our_threads = 99
    teller = threading.Thread(target=line.tell, args=(frame,))
    teller.start()
    assert line.wire.exchange(GO_ON) == frame
    teller.join()
    line.close()


def test_it_ends_at_once_when_the_match_is_gone(line: Line, monkeypatch: pytest.MonkeyPatch) -> None:
    def leave(status: int) -> None:
        raise SystemExit(status)

    monkeypatch.setattr(_wire, "leave", leave)
    monkeypatch.setattr(_wire, "_AWAKE_S", 60.0)
    line.hang_up()
    with pytest.raises(SystemExit):
        line.wire.exchange(GO_ON)


READS_ITS_GPS = """from controller import Robot
robot = Robot()
gps = robot.getDevice("gps")
gps.enable(32)
while robot.step(32) != -1:
    print(int(gps.getValues()[0]))
"""
WITH_A_THREAD = "import threading, time\nthreading.Thread(target=time.sleep, args=(100,), daemon=True).start()\n"


TURNS_ON_LINUX = pytest.mark.skipif(sys.platform != "linux", reason="only Linux has such a way of taking turns")


@TURNS_ON_LINUX
@pytest.mark.parametrize("sandbox", ["auto", "off"])
def test_a_program_gives_way_and_takes_its_turn_again(match: FakeMatch, sandbox: str) -> None:
    here, ours = current_cpu(), os.sched_getaffinity(0)
    assert here in ours
    apart, room, beside = CpuShare(is_batch=True, leaves_cpu=here), CpuShare(is_batch=True), CpuShare(keeps_to_cpu=here)
    others = ours - {here} or ours
    # One thread is there before the request, one begins while it keeps to fewer processors.
    team = match.team(WITH_A_THREAD + READS_ITS_GPS + "    " + WITH_A_THREAD.replace("\n", "\n    "))
    with match.pool(sandbox=sandbox) as pool:
        program = pool.add(SPEC, team, team.entry_for("Y1", "robot.py"))
        pool.launch()
        program.collect()
        process = program._process
        assert process is not None
        pid, threads = process._pid_to_look_at(), []
        for share, policy, where in (
            (room, os.SCHED_BATCH, ours),
            (apart, os.SCHED_BATCH, others),
            (DEFAULT_SHARE, os.SCHED_OTHER, ours),
            (beside, os.SCHED_OTHER, {here}),
            (CpuShare(keeps_to_cpu=max(ours) + 1), os.SCHED_OTHER, ours),  # none of ours
            (apart, os.SCHED_BATCH, others),
        ):
            program.share_cpus(share)
            threads.append([int(thread.name) for thread in Path(f"/proc/{pid}/task").iterdir()])
            assert {os.sched_getscheduler(thread) for thread in threads[-1]} == {policy}
            assert all(os.sched_getaffinity(thread) == where for thread in threads[-1])
            computed_s = program.computed_s()
            program.release(Observation(1, values_at(1), []))
            assert not isinstance(program.collect(), Fault)
            assert program.computed_s() > computed_s > 0.0
        assert len(threads[0]) < len(threads[-1])
        program.kill()
        program.share_cpus(room)  # a program that has ended is not interrupted
        assert program.computed_s() == 0.0
        pool.close()


@TURNS_ON_LINUX
def test_a_program_sees_the_same_set_of_processors_all_along(match: FakeMatch) -> None:
    ours, played = os.sched_getaffinity(0), Played()
    team = match.team(
        "import os\nfrom controller import Robot\nrobot = Robot()\nwhile robot.step(32) != -1:\n"
        "    print(sorted(os.sched_getaffinity(0)), os.sched_getaffinity(os.getpid()) == os.sched_getaffinity(0))\n"
    )
    with match.pool() as pool:
        program = pool.add(SPEC, team, team.entry_for("Y1", "robot.py"))
        pool.launch()
        program.collect()
        for share in (DEFAULT_SHARE, CpuShare(is_batch=True, leaves_cpu=min(ours)), CpuShare(keeps_to_cpu=max(ours))):
            program.share_cpus(share)
            program.release(Observation(1, values_at(1), []))
            assert not isinstance(program.collect(), Fault)
        pool.close()
        played.log = program.new_output()
    assert played.said == [f"{sorted(ours)} True"] * 3


@pytest.mark.parametrize(("rounds", "is_long"), [(0, False), (2_000_000, True)])
def test_a_wait_that_turns_out_long_is_reported_once(
    either_match: FakeMatch, rounds: int, is_long: bool
) -> None:  # fmt: skip
    team, reported = either_match.team(READS_ITS_GPS + f"    for _ in range({rounds}): pass\n"), []
    with either_match.pool() as pool:
        program = pool.add(SPEC, team, team.entry_for("Y1", "robot.py"))
        pool.launch()
        program.collect()
        waits = []
        for tick in range(1, 8):
            reported.clear()
            program.release(Observation(tick, values_at(tick), []))
            assert not isinstance(program.collect(lambda: reported.append("long")), Fault)
            waits.append(len(reported))
        pool.close()
    # A busy computer may hold up one that computes nothing, or us while one computes, but rarely every time.
    assert max(waits) == 1 if is_long else min(waits) == 0
