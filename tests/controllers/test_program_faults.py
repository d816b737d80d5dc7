"""Each way in which a program can fail, and what the match then knows of it."""

from __future__ import annotations

import errno
import os
import signal
import sys
import tempfile
import time
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from fake_match import FakeMatch, robot_spec, values_at

from rcj_challenges.controllers import pipes, processes, scratch
from rcj_challenges.controllers.team import open_team
from rcj_challenges.facts.errors import HostError
from rcj_challenges.facts.play import Fault
from rcj_challenges.facts.traffic import Observation, Request

posix = pytest.mark.skipif(sys.platform == "win32", reason="POSIX only")
needs_linux = pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells how many threads a process has")


def fault_of(match: FakeMatch, program: str, ticks: int = 30) -> Fault:
    played = match.play(program, ticks)
    assert played.fault is not None
    assert f"[{played.fault.kind}] Y1 at tick {played.fault.tick} " in played.log
    return played.fault


def test_a_crash_is_told_with_the_programs_own_traceback(either_match: FakeMatch) -> None:
    fault = fault_of(either_match, "faults/crashes_in_play")
    assert fault == Fault(
        robot="Y1",
        kind="crash",
        tick=3,
        half=1,
        detail="ZeroDivisionError: division by zero (crashes_in_play.py, line 5)",
        traceback=fault.traceback,
    )
    lines = fault.traceback.splitlines()
    assert lines[0] == "Traceback (most recent call last):"
    assert [line for line in lines if line.startswith("  File")] == [
        '  File "crashes_in_play.py", line 12, in <module>',
        '  File "crashes_in_play.py", line 5, in drive',
    ]
    assert "    return 1 / number" in lines


def test_an_import_that_was_not_packed_is_a_crash_before_the_first_tick(match: FakeMatch) -> None:
    fault = fault_of(match, "faults/crashes_at_import")
    assert (fault.kind, fault.tick) == ("crash", 0)
    assert fault.detail == (
        "ModuleNotFoundError: No module named 'a_module_that_was_not_packed' (crashes_at_import.py, line 2)"
    )


def test_a_syntax_error_names_file_and_line(match: FakeMatch) -> None:
    fault = fault_of(match, "faults/has_a_syntax_error")
    assert fault.kind == "crash"
    assert fault.detail.startswith("SyntaxError: ")
    assert fault.detail.endswith(" (has_a_syntax_error.py, line 4)")


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "cp1252"])
def test_a_file_that_is_no_utf_8_is_told_with_what_to_do(match: FakeMatch, encoding: str) -> None:
    """Editors on Windows save in such ways; Python speaks of "null bytes", and names no file."""
    source = "from controller import Robot\nprint('Müller')\n".encode(encoding)
    (match.folder / "robot.py").write_bytes(source)
    fault = match.play(open_team(match.folder / "robot.py")).fault
    assert fault is not None
    assert fault.detail.startswith("SyntaxError: ")
    assert "robot.py" in fault.detail
    assert fault.detail.endswith("; save the file as UTF-8 text in your editor")


def test_a_module_that_is_no_utf_8_is_told_where_it_is_imported(match: FakeMatch) -> None:
    (match.folder / "robot.py").write_text("import controller\nimport tools\n", encoding="utf-8")
    (match.folder / "tools.py").write_bytes("x = 1\n".encode("utf-16"))
    fault = match.play(open_team(match.folder)).fault
    assert fault is not None
    assert fault.detail.endswith("(robot.py, line 2); save the file as UTF-8 text in your editor")


def test_an_encoding_that_there_is_not_is_told_with_the_file(match: FakeMatch) -> None:
    fault = fault_of(match, "# -*- coding: uft-8 -*-\nimport controller\n")
    assert fault.detail == "SyntaxError: unknown encoding: uft-8 (robot.py, line 1)"


def test_the_traceback_of_a_chained_error_tells_both_and_nothing_of_this_project(match: FakeMatch) -> None:
    program = """
from controller import Robot
robot = Robot()
robot.step(32)
receiver = robot.getDevice("team receiver")
try:
    receiver.getData()
except RuntimeError as error:
    raise ValueError(f"{object()}") from error
"""
    fault = fault_of(match, program)
    assert fault.detail == "ValueError: <object object at 0x…> (robot.py, line 9)"
    assert "direct cause" in fault.traceback
    assert "radio.py" not in fault.traceback
    assert str(match.folder) not in fault.traceback


def test_no_path_of_this_computer_is_told(match: FakeMatch) -> None:
    program = """
import os
from controller import Robot
try:
    from numpy import no_such_thing
except ImportError as error:
    raise RuntimeError(f"{os.getcwd()} {os.environ['HOME']} {error}")
"""
    fault = fault_of(match, program)
    assert fault.detail.replace("\\", "/").startswith(
        "RuntimeError: . ~ cannot import name 'no_such_thing' from 'numpy' (site-packages/numpy/__init__.py)"
    )


@posix
def test_where_a_program_broke_the_interpreter_stands_in_its_log(match: FakeMatch) -> None:
    program = """
import ctypes
from controller import Robot
robot = Robot()
robot.step(32)
ctypes.string_at(0)
"""
    played = match.play(program, 5)
    assert played.fault is not None
    assert (played.fault.kind, played.fault.detail) == ("crash", "the program was ended by the signal SIGSEGV")
    assert '  File "robot.py", line 6 in <module>' in played.said
    assert str(match.folder) not in played.log


def test_where_a_program_broke_the_interpreter_is_told_as_each_system_does_it(match: FakeMatch) -> None:
    """Windows has no signals: there the interpreter says "Windows fatal exception: access violation"."""
    program = "import faulthandler\nfrom controller import Robot\nRobot().step(32)\nfaulthandler._read_null()\n"
    played = match.play(program, 5)
    assert played.fault is not None
    why = "exception 0xc0000005" if sys.platform == "win32" else "signal SIGSEGV"
    assert (played.fault.kind, played.fault.detail) == ("crash", f"the program was ended by the {why}")
    assert played.said[:2] == ["It was here, the innermost call first:", '  File "robot.py", line 4 in <module>']
    assert str(match.folder) not in played.log
    assert "controller" not in played.log


def test_a_fault_is_the_same_in_every_run(match: FakeMatch) -> None:
    assert fault_of(match, "faults/crashes_in_play") == fault_of(match, "faults/crashes_in_play")


def test_a_program_that_never_steps_is_stopped_at_its_start(either_match: FakeMatch) -> None:
    either_match.limits = either_match.limits.model_copy(update={"start_s": 0.7})
    fault = fault_of(either_match, "faults/never_steps")
    assert (fault.kind, fault.tick) == ("start_timeout", 0)
    assert fault.detail == "the program did not call step within 0.7 s of its start"


def test_a_program_that_hangs_is_stopped_at_the_limit_and_its_log_shows_where(tmp_path: Path) -> None:
    match = FakeMatch(tmp_path, step_s=0.4)
    began = time.perf_counter()
    played = match.play("faults/hangs_in_play", 10)
    assert played.fault is not None
    assert (played.fault.kind, played.fault.tick) == ("step_timeout", 2)
    assert played.fault.detail == "the program did not call step for 0.4 s"
    assert time.perf_counter() - began < 10
    assert "now it hangs" in played.log
    where = played.log.split("It was here, the innermost call first:\n")[1].splitlines()
    assert where[0].startswith('  File "hangs_in_play.py", line ')
    assert where[1].startswith("[step_timeout] Y1 at tick 2 (0.064 s): ")


def test_where_it_hangs_is_told_also_of_files_with_umlauts_below_a_users_folder_with_umlauts(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "Jörg Ω").mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "Jörg Ω"))
    (tmp_path / "t").mkdir()
    (tmp_path / "t" / "robot.py").write_text("import größe\n", encoding="utf-8")
    (tmp_path / "t" / "größe.py").write_text("def drehe_für():\n    while True: pass\ndrehe_für()\n", encoding="utf-8")
    played = FakeMatch(tmp_path, start_s=2.0).play(open_team(tmp_path / "t"))
    where = played.log.split("It was here, the innermost call first:\n")[1].splitlines()
    assert where[:3] == [
        '  File "größe.py", line 2 in drehe_für',
        '  File "größe.py", line 3 in <module>',
        '  File "robot.py", line 1 in <module>',
    ]


@posix
def test_where_no_signal_can_ask_for_it_a_watch_tells_where_a_program_hangs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(processes, "signal", SimpleNamespace(SIGABRT=0, SIGCONT=0, SIGKILL=signal.SIGKILL))
    (tmp_path / "t" / "robot1").mkdir(parents=True)
    (tmp_path / "t" / "robot1" / "robot1.py").write_text("import turns\n", encoding="utf-8")
    (tmp_path / "t" / "robot1" / "turns.py").write_text("def turn():\n    while True: pass\nturn()\n", encoding="utf-8")
    match = FakeMatch(tmp_path, portable=True, start_s=0.7)
    played = match.play(open_team(tmp_path / "t"), entry="robot1/robot1.py")
    assert played.fault is not None
    assert played.fault.kind == "start_timeout"
    where = played.log.split("It was here, the innermost call first:\n")[1].splitlines()
    assert where[:3] == [
        '  File "robot1/turns.py", line 2 in turn',
        '  File "robot1/turns.py", line 3 in <module>',
        '  File "robot1/robot1.py", line 1 in <module>',
    ]


def test_a_program_that_is_slow_on_every_step_is_stopped_by_the_sum(tmp_path: Path) -> None:
    fault = fault_of(FakeMatch(tmp_path, half_s=0.3), "faults/slow_on_every_step", 1000)
    assert fault.kind == "half_timeout"
    assert fault.detail == "the program let the match wait for 0.3 s in all"
    assert 1 <= fault.tick <= 20  # 5, and more where other programs take the processor: that time is not charged


def test_a_temporary_folder_that_cannot_be_used_is_no_programs_fault(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    match = FakeMatch(tmp_path)
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "gone"))
    with pytest.raises(HostError) as raised:
        match.play("pass\n")
    assert str(raised.value).startswith(f"the temporary folder {tmp_path / 'gone'} cannot be used: ")


@posix
def test_while_the_match_itself_stands_still_nobodys_time_runs_out(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Ctrl-Z, and ``fg`` after an hour: each program is charged what one step may take, and no more."""
    stood_s, bodies = [0.0], list[bytes | None]()
    clock = SimpleNamespace(perf_counter=lambda: time.perf_counter() + stood_s[0])
    monkeypatch.setattr("rcj_challenges.controllers.program.time", clock)
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


@pytest.mark.parametrize(
    ("program", "detail", "tick"),
    [
        ("exits_quietly", "the program called sys.exit(4)", 3),
        ("exits_hard", "the program ended itself (exit status 3)", 1),
        ("comes_to_its_end", "the program came to its end while the match goes on: it has to call step in a loop", 1),
    ],
)
def test_a_program_that_leaves_while_the_match_goes_on_is_told_so(
    either_match: FakeMatch, program: str, detail: str, tick: int
) -> None:
    fault = fault_of(either_match, f"faults/{program}")
    assert (fault.kind, fault.tick, fault.detail) == ("exit", tick, detail)


def test_who_leaves_with_a_negative_status_has_left_and_not_crashed(match: FakeMatch) -> None:
    """Windows tells -1 as 0xffffffff, beside what it tells of crashes; POSIX tells the lowest eight bits."""
    fault = fault_of(match, "import os\nfrom controller import Robot\nRobot().step(32)\nos._exit(-1)\n")
    assert (fault.kind, fault.tick, fault.detail) == ("exit", 1, "the program ended itself (exit status 255)")


@pytest.mark.parametrize(
    ("told", "status", "is_crash"),
    [
        (0, 0, False),
        (139, 139, False),  # 128 + n is nothing special there
        (0xFFFFFFFF, 255, False),  # exit(-1)
        (0xFFFFFFFE, 254, False),
        (0xC0000005, 0xC0000005, True),  # access violation
        (0xE06D7363, 0xE06D7363, True),  # an exception of C++
    ],
)
def test_what_an_exit_status_of_windows_means(
    monkeypatch: pytest.MonkeyPatch, told: int, status: int, is_crash: bool
) -> None:
    monkeypatch.setattr("rcj_challenges.controllers.processes.sys.platform", "win32")
    popen: Any = SimpleNamespace(wait=lambda _: told)
    seen = processes.Process(popen, None, own_session=True).exit_status(1.0)
    assert seen == status
    assert processes.is_crash(seen) is is_crash


def test_quit_with_words_leaves_them_in_the_log(match: FakeMatch) -> None:
    played = match.play("from controller import Robot\nRobot().step(32)\nquit('no more')\n", 5)
    assert played.fault is not None
    assert (played.fault.kind, played.fault.detail) == ("exit", "the program called sys.exit: no more")
    assert played.said[0] == "no more"


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


def test_a_flood_past_the_counter_is_stopped_by_the_size_of_the_log(tmp_path: Path) -> None:
    match = FakeMatch(tmp_path, output_mb=0.5)
    fault = fault_of(match, "faults/floods_the_descriptor")
    assert (fault.kind, fault.tick) == ("output_flood", 1)


def test_a_program_that_fills_its_folder_is_stopped(tmp_path: Path) -> None:
    fault = fault_of(FakeMatch(tmp_path, scratch_mb=5), "faults/fills_its_folder")
    assert (fault.kind, fault.tick) == ("output_flood", 1)
    assert fault.detail == "the program wrote more than 5 MB into its folder"


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
        monkeypatch.setattr("rcj_challenges.controllers.program._SLICE_S", wait_s)

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


def test_who_writes_fast_is_stopped_before_its_folder_is_looked_through_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("rcj_challenges.controllers.program._SLICE_S", 1e-6)
    # Only while the match waits is the folder looked at earlier: so it computes too, and the match has to wait for it.
    fast = WRITES_ON_EVERY_TICK.replace("5_000", "100_000").replace("if robot", "sum(range(50_000))\n    if robot")
    fault = fault_of(FakeMatch(tmp_path, scratch_mb=1), fast, 300)
    assert fault.kind == "output_flood"
    assert 19 <= fault.tick < 60


@posix
def test_a_program_that_is_killed_by_a_signal_has_crashed(match: FakeMatch) -> None:
    fault = fault_of(match, "faults/breaks_by_a_signal")
    assert (fault.kind, fault.tick, fault.detail) == ("crash", 1, "the program was ended by the signal SIGKILL")


def test_a_program_that_closes_its_connection_breaks_the_protocol(match: FakeMatch) -> None:
    fault = fault_of(match, "faults/closes_its_connection")
    assert (fault.kind, fault.tick, fault.detail) == (
        "protocol",
        1,
        "the program closed its connection to the match",
    )


@posix
def test_a_program_that_talks_garbage_breaks_the_protocol(either_match: FakeMatch) -> None:
    fault = fault_of(either_match, "faults/talks_garbage")
    assert (fault.kind, fault.tick) == ("protocol", 1)
    assert fault.detail == "the program sent what is no message: a message of unknown type 104"


@posix
def test_a_program_that_announces_an_endless_message_breaks_the_protocol(either_match: FakeMatch) -> None:
    garbage = (Path(__file__).parent.parent / "programs/faults/talks_garbage.py").read_text(encoding="utf-8")
    fault = fault_of(either_match, garbage.replace(r"\x05\x00\x00\x00hello", r"\xff\xff\xff\xff"))
    assert (fault.kind, fault.detail) == ("protocol", "the program sent a message of 4294967295 bytes")


def test_a_program_that_failed_stays_dead_and_says_the_same_again(match: FakeMatch) -> None:
    with match.crew() as crew:
        from fake_match import SPEC

        team = match.team("faults/crashes_at_import")
        program = crew.add(SPEC, team, team.entry_for("Y1", "robot.py"))
        crew.launch()
        first = program.collect()
        assert isinstance(first, Fault)
        assert program.collect() == first == program.fault
        assert program.has_ended()


def test_a_program_of_a_folder_is_told_by_its_path_in_the_folder(match: FakeMatch, tmp_path: Path) -> None:
    (tmp_path / "t" / "robot1").mkdir(parents=True)
    (tmp_path / "t" / "robot1" / "robot1.py").write_text("import tools\n", encoding="utf-8")
    (tmp_path / "t" / "robot1" / "tools.py").write_text("open('missing.txt')\n", encoding="utf-8")
    played = match.play(open_team(tmp_path / "t"), entry="robot1/robot1.py")
    assert played.fault is not None
    assert played.fault.detail == (
        "FileNotFoundError: [Errno 2] No such file or directory: 'missing.txt' (robot1/tools.py, line 1)"
    )


@pytest.mark.parametrize("name", ["token", "traceback"])
def test_a_crash_is_told_whatever_the_team_called_its_files(match: FakeMatch, tmp_path: Path, name: str) -> None:
    (tmp_path / "t").mkdir()
    (tmp_path / "t" / f"{name}.py").write_text("SPEED = 5\n", encoding="utf-8")
    program = (
        f"import {name}\nfrom controller import Robot\nRobot().getDevice('left wheel motor').setVelocty({name}.SPEED)\n"
    )
    (tmp_path / "t" / "robot.py").write_text(program, encoding="utf-8")
    played = match.play(open_team(tmp_path / "t"), 2)
    assert played.fault is not None
    assert played.fault.detail == (
        "AttributeError: 'Motor' object has no attribute 'setVelocty'. Did you mean: 'setVelocity'? (robot.py, line 3)"
    )
    assert "line 3, in <module>" in played.fault.traceback


def test_a_crash_is_told_in_short_where_the_program_has_broken_what_tells_it(match: FakeMatch) -> None:
    program = "import traceback\ntraceback.TracebackException = None\nraise ValueError('too fast')\n"
    played = match.play(program, 2)
    assert played.fault is not None
    assert played.fault.detail == "ValueError: too fast (robot.py, line 3)"


def test_what_a_program_said_last_counts_though_it_arrives_after_its_end(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def late(fd: int, size: int) -> bytes:
        data = os.read(fd, size)
        time.sleep(0.4)  # longer than the program is waited for at a time
        return data

    monkeypatch.setattr(pipes, "os", SimpleNamespace(read=late, write=os.write, close=os.close))
    fault = fault_of(FakeMatch(tmp_path, portable=True), "import no_such_thing\n")
    assert (fault.kind, fault.tick) == ("crash", 0)
    assert fault.detail.startswith("ModuleNotFoundError: No module named 'no_such_thing'")


def test_a_dead_program_does_not_end_the_others(match: FakeMatch) -> None:
    from fake_match import Played, play_on, robot_spec

    sane, broken = match.team("patterns/keeps_state_at_module_level"), match.team("faults/exits_hard")
    with match.crew() as crew:
        first = crew.add(robot_spec("Y1"), broken, broken.entry_for("Y1", "robot.py"))
        second = crew.add(robot_spec("Y2"), sane, sane.entry_for("Y2", "robot.py"))
        crew.launch()
        one, two = Played(), Played()
        play_on(first, one, 20)
        play_on(second, two, 20)
    assert one.fault is not None
    assert two.fault is None
    assert len(two.requests) == 20


def test_a_process_that_cannot_be_started_is_a_fault_of_that_program_only(
    match: FakeMatch, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise OSError(7, "Argument list too long", "/home/somebody/python")

    monkeypatch.setattr(processes, "start", refuse)
    fault = fault_of(match, "faults/never_steps")
    assert (fault.kind, fault.tick) == ("start", 0)
    assert fault.detail == "the program could not be started: Argument list too long"  # and no path


@pytest.mark.parametrize("number", [errno.ENOMEM, errno.ENOSPC, errno.EMFILE])
def test_what_this_computer_lacks_is_no_fault_of_a_program(
    match: FakeMatch, monkeypatch: pytest.MonkeyPatch, number: int
) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise OSError(number, "it is lacking")

    monkeypatch.setattr(processes, "start", refuse)
    with pytest.raises(HostError, match="the program of Y1 cannot be started here: it is lacking"):
        fault_of(match, "faults/never_steps")


@pytest.mark.parametrize("code", [14, 39, 1450, 1455])
def test_what_this_computer_lacks_is_told_by_windows_in_numbers_of_its_own(
    match: FakeMatch, monkeypatch: pytest.MonkeyPatch, code: int
) -> None:
    """Such as 1455, "the paging file is too small": their ``errno`` is only EINVAL."""
    error = OSError(errno.EINVAL, "it is lacking")
    error.winerror = code  # type: ignore[attr-defined, unused-ignore]

    def refuse(*_: object, **__: object) -> None:
        raise error

    monkeypatch.setattr(processes, "start", refuse)
    with pytest.raises(HostError, match="the program of Y1 cannot be started here: it is lacking"):
        fault_of(match, "faults/never_steps")


FINDS_NO_ROOM = """
from controller import Robot
Robot().step(32)
try:
    raise OSError(28, "No space left on device")  # as of a write
except OSError as error:
    raise ValueError("my notes") from error
"""


@pytest.fixture
def _full(monkeypatch: pytest.MonkeyPatch) -> None:
    """The temporary folder is full, and one has filled it that has written more than 100 kB."""

    def full(_: Path) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(scratch, "ensure_room", full)
    monkeypatch.setattr(scratch, "share_bytes", lambda *_: 100_000)


@pytest.mark.usefixtures("_full")
def test_a_temporary_folder_without_room_is_no_fault_of_a_program(match: FakeMatch) -> None:
    with pytest.raises(HostError) as raised:
        match.play(FINDS_NO_ROOM, 3)
    variable = "TEMP" if sys.platform == "win32" else "TMPDIR"
    assert str(raised.value) == (
        f"the temporary folder {tempfile.gettempdir()} is full: the program of Y1 could not write at tick 1 (0.032 s): "
        f"No space left on device; make room there, or let {variable} name another"
    )


WRITES_MUCH = """
from controller import Robot
with open("much", "wb") as file:
    file.write(bytes(200_000))
robot = Robot()
while robot.step(32) != -1:
    pass
"""


@pytest.mark.usefixtures("_full")
def test_who_has_filled_the_temporary_folder_pays_and_the_match_goes_on(match: FakeMatch) -> None:
    with match.crew() as crew:
        programs = {}
        for name, program in (("Y1", WRITES_MUCH), ("B1", FINDS_NO_ROOM)):
            team = match.team(program)
            programs[name] = crew.add(robot_spec(name), team, team.entry_for(name, "robot.py"))
        crew.launch()
        greedy, poor = programs.values()
        assert isinstance(greedy.collect(), Request)
        poor.collect()
        poor.release(Observation(1, values_at(1), []))
        fault = poor.collect()
        assert (fault.robot, fault.kind) == ("B1", "crash")
        assert fault.detail.endswith("; the temporary folder was full of what Y1 had written")
        # It is told when its turn comes, or when somebody looks after it because it stays away.
        greedy.release(Observation(1, values_at(1), []))
        assert greedy.collect() is greedy.overstepped(1)
        assert (greedy.fault.kind, greedy.fault.detail) == (
            "output_flood",
            "the program wrote more than its share, 0.1 MB, until the temporary folder was full",
        )
        assert not any(path.is_dir() for path in crew._folders.place.iterdir()), "the room is there again"


def test_who_only_says_that_there_is_no_room_has_crashed(match: FakeMatch) -> None:
    assert fault_of(match, FINDS_NO_ROOM).kind == "crash"


@pytest.mark.parametrize(
    ("line", "meant"),
    [
        ("motor.setvelocity(3)", "setVelocity"),
        ("print(velocty)", "velocity"),
        ("import math\nmath.atan3(1, 2)", "atan"),
        ("prnt(1)", "print"),
    ],
)
def test_a_slip_of_the_pen_is_told_with_what_was_meant(match: FakeMatch, line: str, meant: str) -> None:
    program = f"""
from controller import Robot
robot = Robot()
motor, velocity = robot.getDevice("left wheel motor"), 3
robot.step(32)
{line}
"""
    fault = match.play(program, 2).fault
    assert fault is not None
    hint = f"Did you mean: '{meant}"
    assert hint in fault.detail
    assert fault.traceback.count(hint) == 1


def test_a_name_like_no_other_is_told_as_it_is(match: FakeMatch) -> None:
    fault = match.play("from controller import Robot\nRobot().step(32)\nxyzzy_of_no_kind()", 2).fault
    assert fault is not None
    assert fault.detail == "NameError: name 'xyzzy_of_no_kind' is not defined (robot.py, line 3)"
