"""Each way in which a program can fail, and what the match then knows of it."""

from __future__ import annotations

import os
import re
import sys
import time
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from fake_match import SPEC, FakeMatch, fault_of

from rcj_challenges.programs import pipes, processes
from rcj_challenges.submissions.team import open_team
from rcj_challenges.core.play import Fault

posix = pytest.mark.skipif(sys.platform == "win32", reason="POSIX only")

STEPPED = "from controller import Robot\nrobot = Robot()\nmotor = robot.getDevice('left wheel motor')\nvelocity = 3\nrobot.step(32)\n"
LEFT_BY = 'space = {"__name__": "%s"}\nexec("def do_quit():\\n    raise SystemExit(1)", space)\nspace["do_quit"]()\n'

FAULTS: dict[str, tuple[str, str, int, str]] = {
    "an import that was not packed": (
        "faults/crashes_at_import", "crash", 0,
        r"ModuleNotFoundError: No module named 'a_module_that_was_not_packed' \(crashes_at_import.py, line 2\)",
    ),
    "a syntax error": ("faults/has_a_syntax_error", "crash", 0, r"SyntaxError: .* \(has_a_syntax_error.py, line 4\)"),
    "an encoding that does not exist": (
        "# -*- coding: uft-8 -*-\nimport controller\n", "crash", 0,
        r"SyntaxError: unknown encoding: uft-8 \(robot.py, line 1\)",
    ),
    "paths of this computer": (
        ("import os\ntry:\n    from numpy import no_such_thing\nexcept ImportError as error:\n"
        "    raise RuntimeError(f\"{os.getcwd()} {os.environ['HOME']} {error}\")\n"),
        "crash", 0,
        r"RuntimeError: \. ~ cannot import name 'no_such_thing' from 'numpy' \(site-packages[/\\]numpy[/\\]__init__.py\).*",
    ),
    "a misspelt method": (
        f"{STEPPED}motor.setvelocity(3)", "crash", 1,
        r"AttributeError: .*\. Did you mean: 'setVelocity'\? \(robot.py, line 6\)",
    ),
    "a misspelt variable": (
        f"{STEPPED}print(velocty)", "crash", 1, r"NameError: .*\. Did you mean: 'velocity'\? \(robot.py, line 6\)",
    ),
    "a misspelt name of a module": (
        f"{STEPPED}import math\nmath.atan3(1, 2)", "crash", 1,
        r"AttributeError: .*\. Did you mean: 'atan.?'\? \(robot.py, line 7\)",
    ),
    "a misspelt name of Python": (
        f"{STEPPED}prnt(1)", "crash", 1, r"NameError: .*\. Did you mean: 'print'\? \(robot.py, line 6\)",
    ),
    "a name like no other": (
        f"{STEPPED}xyzzy_of_no_kind()", "crash", 1, r"NameError: name 'xyzzy_of_no_kind' is not defined \(robot.py, line 6\)",
    ),
    "anything in the path of modules": (
        "import pathlib, sys\nsys.path += [pathlib.Path('lib'), b'lib', None]\nraise ValueError('too fast')\n", "crash", 0,
        r"ValueError: too fast \(robot.py, line 3\)",
    ),
    "a broken module that formats errors": (
        "import traceback\ntraceback.TracebackException = None\nraise ValueError('too fast')\n", "crash", 0,
        r"ValueError: too fast \(robot.py, line 3\)",
    ),
    "sys.exit": ("faults/exits_quietly", "exit", 3, r"the program called sys.exit\(4\)"),
    "quit with a text": (f"{STEPPED}quit('no more')", "exit", 1, r"the program called sys.exit: no more"),
    # Windows reports -1 as 0xffffffff, beside its codes of crashes; POSIX reports the lowest eight bits.
    "os._exit with a negative status": (
        f"{STEPPED}import os\nos._exit(-1)", "exit", 1, r"the program ended itself \(exit status 255\)",
    ),
    "its end": (
        "faults/comes_to_its_end", "exit", 1,
        r"the program came to its end while the match goes on: it has to call step in a loop",
    ),
    "a debugger without a terminal": (f"{STEPPED}import pdb\npdb.set_trace()\nrobot.step(32)", "crash", 1, r"bdb.BdbQuit.*"),
    # From Python 3.14 on it calls sys.exit(1), which the program did not.
    "a debugger of Python 3.14": (f"import bdb\n{LEFT_BY % 'pdb'}", "crash", 0, r"bdb.BdbQuit.*"),
    "a function of the program that is called as the debugger's": (
        LEFT_BY % "robot", "exit", 0, r"the program called sys.exit\(1\)",
    ),
}  # fmt: skip


@pytest.mark.parametrize("reason", FAULTS)
def test_a_fault_has_its_kind_tick_and_reason(match: FakeMatch, reason: str) -> None:
    program, kind, tick, detail = FAULTS[reason]
    fault = fault_of(match, program)
    assert (fault.kind, fault.tick) == (kind, tick)
    assert re.fullmatch(detail, fault.detail)


def test_a_crash_is_reported_with_the_programs_own_traceback(either_match: FakeMatch) -> None:
    fault = fault_of(either_match, "faults/crashes_in_play")
    detail = "ZeroDivisionError: division by zero (crashes_in_play.py, line 5)"
    assert fault == Fault("Y1", "crash", 3, 1, detail, fault.traceback)
    lines = fault.traceback.splitlines()
    assert lines[0] == "Traceback (most recent call last):"
    assert [line for line in lines if line.startswith("  File")] == [
        '  File "crashes_in_play.py", line 12, in <module>',
        '  File "crashes_in_play.py", line 5, in drive',
    ]
    assert "    return 1 / number" in lines


@pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "cp1252"])
@pytest.mark.parametrize("name", ["robot", "tools"])
def test_a_file_that_is_not_utf_8_is_reported_with_what_to_do(match: FakeMatch, encoding: str, name: str) -> None:
    """Editors on Windows save in such ways; Python speaks of "null bytes", and names no file."""
    (match.folder / "robot.py").write_text("import controller\nimport tools\n", encoding="utf-8")
    (match.folder / f"{name}.py").write_bytes("from controller import Robot\nprint('Müller')\n".encode(encoding))
    fault = match.play(open_team(match.folder)).fault
    assert fault is not None
    assert ".py" in fault.detail
    assert fault.detail.endswith("; save the file as UTF-8 text in your editor")


def test_the_traceback_of_a_chained_error_has_both_errors_and_nothing_of_this_project(match: FakeMatch) -> None:
    program = f"{STEPPED}try:\n    robot.getDevice('team receiver').getData()\nexcept RuntimeError as error:\n"
    fault = fault_of(match, f"{program}    raise ValueError(f'{{object()}}') from error\n")
    assert fault.detail == "ValueError: <object object at 0x…> (robot.py, line 9)"
    assert "direct cause" in fault.traceback
    assert "radio.py" not in fault.traceback
    assert str(match.folder) not in fault.traceback


def test_the_place_where_a_program_broke_the_interpreter_is_in_its_log(match: FakeMatch) -> None:
    """Windows has no signals: there the interpreter says "Windows fatal exception: access violation"."""
    program = "import faulthandler\nfrom controller import Robot\nRobot().step(32)\nfaulthandler._read_null()\n"
    played = match.play(program, 5)
    assert played.fault is not None
    why = "exception 0xc0000005" if sys.platform == "win32" else "signal SIGSEGV"
    assert (played.fault.kind, played.fault.detail) == ("crash", f"the program was ended by the {why}")
    assert played.said[:2] == ["It was here, the innermost call first:", '  File "robot.py", line 4 in <module>']
    assert str(match.folder) not in played.log
    assert "controller" not in played.log


@pytest.mark.parametrize(
    ("program", "kind", "detail"),
    [
        ("exits_hard", "exit", "the program ended itself (exit status 3)"),
        ("closes_its_connection", "protocol", "the program closed its connection to the match"),
        pytest.param("breaks_by_a_signal", "crash", "the program was ended by the signal SIGKILL", marks=posix),
        pytest.param(
            "talks_garbage",
            "protocol",
            "the program sent an invalid message: a message of unknown type 104",
            marks=posix,
        ),
    ],
)
def test_a_program_that_ends_the_exchange_has_a_fault(
    either_match: FakeMatch, program: str, kind: str, detail: str
) -> None:
    fault = fault_of(either_match, f"faults/{program}")
    assert (fault.kind, fault.tick, fault.detail) == (kind, 1, detail)


@pytest.mark.parametrize(
    ("reported", "status", "is_crash"),
    [
        (139, 139, False),  # 128 + n is nothing special there
        (0xFFFFFFFF, 255, False),  # exit(-1)
        (0xFFFFFFFE, 254, False),
        (0xC0000005, 0xC0000005, True),  # access violation
        (0xE06D7363, 0xE06D7363, True),  # an exception of C++
    ],
)
def test_what_an_exit_status_of_windows_means(
    monkeypatch: pytest.MonkeyPatch, reported: int, status: int, is_crash: bool
) -> None:
    monkeypatch.setattr("rcj_challenges.programs.processes.sys.platform", "win32")
    popen: Any = SimpleNamespace(wait=lambda _: reported)
    seen = processes.Process(popen, None, own_session=True).exit_status(1.0)
    assert seen == status
    assert processes.is_crash(seen) is is_crash


def test_a_failed_program_stays_dead_and_repeats_its_failure(match: FakeMatch) -> None:
    with match.pool() as pool:
        team = match.team("faults/crashes_at_import")
        program = pool.add(SPEC, team, team.single)
        pool.launch()
        first = program.collect()
        assert isinstance(first, Fault)
        assert program.collect() == first == program.fault
        assert program.has_ended()


def test_a_fault_names_a_file_by_its_path_in_the_teams_folder(match: FakeMatch, tmp_path: Path) -> None:
    (tmp_path / "t" / "robot1").mkdir(parents=True)
    (tmp_path / "t" / "robot1" / "robot1.py").write_text("import tools\n", encoding="utf-8")
    (tmp_path / "t" / "robot1" / "tools.py").write_text("open('missing.txt')\n", encoding="utf-8")
    played = match.play(open_team(tmp_path / "t"), entry="robot1/robot1.py")
    assert played.fault is not None
    assert played.fault.detail == (
        "FileNotFoundError: [Errno 2] No such file or directory: 'missing.txt' (robot1/tools.py, line 1)"
    )


@pytest.mark.parametrize("name", ["token", "traceback", "difflib"])
def test_a_crash_is_reported_whatever_the_team_called_its_files(match: FakeMatch, tmp_path: Path, name: str) -> None:
    (tmp_path / "t").mkdir()
    (tmp_path / "t" / f"{name}.py").write_text("SPEED = 5\n", encoding="utf-8")
    program = (
        f"import {name}\nfrom controller import Robot\nRobot().getDevice('left wheel motor').setVelocty({name}.SPEED)\n"
    )
    (tmp_path / "t" / "robot.py").write_text(program, encoding="utf-8")
    played = match.play(open_team(tmp_path / "t"), 2)
    assert played.fault is not None
    hint = "AttributeError: 'Motor' object has no attribute 'setVelocty'. Did you mean: 'setVelocity'?"
    assert played.fault.detail == f"{hint} (robot.py, line 3)"
    assert played.fault.traceback.count(hint) == 1
    assert "line 3, in <module>" in played.fault.traceback


def test_the_last_output_of_a_program_counts_though_it_arrives_after_its_end(
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
