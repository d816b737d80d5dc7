"""Each way in which a program can fail, and what the match then knows of it."""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from fake_match import FakeMatch, fault_of, robot_spec

from rcj_challenges.controllers import pipes, processes
from rcj_challenges.controllers.team import open_team
from rcj_challenges.core.play import Fault

posix = pytest.mark.skipif(sys.platform == "win32", reason="POSIX only")


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


def test_a_debugger_that_finds_nobody_is_told_as_such_by_every_python(match: FakeMatch) -> None:
    """From Python 3.14 on it calls sys.exit(1), which the program did not."""
    fault = fault_of(
        match, "from controller import Robot\nRobot().step(32)\nimport pdb\npdb.set_trace()\nRobot().step(32)\n"
    )
    assert (fault.kind, fault.detail[:11]) == ("crash", "bdb.BdbQuit")
    left = 'import bdb\nspace = {"__name__": "%s"}\nexec("def do_quit():\\n    raise SystemExit(1)", space)\nspace["do_quit"]()\n'
    fault = fault_of(match, left % "pdb")  # so it is there
    assert (fault.kind, fault.detail[:11]) == ("crash", "bdb.BdbQuit")
    assert fault_of(match, left % "robot").kind == "exit"


def test_a_fault_is_the_same_in_every_run(match: FakeMatch) -> None:
    assert fault_of(match, "faults/crashes_in_play") == fault_of(match, "faults/crashes_in_play")


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


@posix
def test_a_program_that_is_killed_by_a_signal_has_crashed(match: FakeMatch) -> None:
    fault = fault_of(match, "faults/breaks_by_a_signal")
    assert (fault.kind, fault.tick, fault.detail) == ("crash", 1, "the program was ended by the signal SIGKILL")


def test_a_program_that_closes_its_connection_breaks_the_protocol(either_match: FakeMatch) -> None:
    fault = fault_of(either_match, "faults/closes_its_connection")
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


@pytest.mark.parametrize("name", ["token", "traceback", "tokenize", "difflib", "re"])
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


@pytest.mark.parametrize("added", ["pathlib.Path('lib')", "b'lib'", "None"])
def test_a_crash_is_told_whatever_the_program_has_put_into_its_path(match: FakeMatch, added: str) -> None:
    played = match.play(f"import pathlib, sys\nsys.path.append({added})\nraise ValueError('too fast')\n", 2)
    assert played.fault is not None
    assert played.fault.detail == "ValueError: too fast (robot.py, line 3)"
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
    from fake_match import Played, play_on

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
