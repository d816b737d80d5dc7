"""What a program prints about its files names them as the team knows them, not where a match put them for an hour."""

from __future__ import annotations

import ntpath
import os
import posixpath
import sys
import tempfile
from functools import reduce
from pathlib import Path
from types import SimpleNamespace

import pytest
from fake_match import FakeMatch

from rcj_challenges.programs.log import ProgramLog
from rcj_challenges.programs.program_side.controller import _traceback
from rcj_challenges.submissions.team import open_team

ENTRY = "robot_blue/robot.py"
FOLDER = f"robot_blue{os.sep}"
"""As programs see it and print it: with the slashes of the system that they run on."""
STEPS = "robot = Robot()\nwhile robot.step(32) != -1:\n    pass\n"


def printed(folder: Path, program: str, **files: str) -> str:
    team = folder / "handed_in"
    (team / "robot_blue").mkdir(parents=True)
    for name, text in {"robot": "from controller import Robot\n" + program + STEPS, **files}.items():
        (team / "robot_blue" / f"{name}.py").write_text(text, encoding="utf-8")
    played = FakeMatch(folder).play(open_team(team), 3, entry=ENTRY)
    assert played.fault is None
    return "\n".join(played.said)


@pytest.mark.parametrize(
    ("program", "says"),
    {
        "of the compiler": ("if 'a' is 1: pass\n", "robot_blue/robot.py:2: SyntaxWarning:"),
        "of the program": ("import warnings\nwarnings.warn('mine')\n", "robot_blue/robot.py:3: UserWarning: mine"),
        "of what is old": (
            "import warnings\nwarnings.warn('old', DeprecationWarning)\n",
            "robot_blue/robot.py:3: DeprecationWarning: old",
        ),
        "of numpy": (
            "import numpy\nnumpy.array([1.0]) / 0\n",
            "robot_blue/robot.py:3: RuntimeWarning: divide by zero encountered in divide",
        ),
        "a traceback": (
            "import traceback\ntry:\n    1 / 0\nexcept ZeroDivisionError:\n    traceback.print_exc()\n",
            'File "robot_blue/robot.py", line 4, in <module>',
        ),
        "a traceback through the module": (
            (
                "import traceback\nrobot = Robot()\ntry:\n    robot.getDevice('gps').enable('fast')\n"
                "except TypeError:\n    traceback.print_exc()\nRobot = lambda: robot\n"
            ),
            f'File "site-packages{os.sep}controller{os.sep}device.py", line ',
        ),
        "the interpreter": ("import sys\nprint(sys.executable, flush=True)\nprint('!')\n", "python\n!"),
        "a thread's end": (
            "import threading\nthread = threading.Thread(target=lambda: 1 / 0)\nthread.start()\nthread.join()\n",
            'File "robot_blue/robot.py", line 3, in <lambda>',
        ),
        "a log": (
            (
                "import logging\nlogging.basicConfig(format='%(pathname)s:%(lineno)d %(message)s')\n"
                "logging.warning('low')\n"
            ),
            "robot_blue/robot.py:4 low",
        ),
        "the file's name": (
            "print(__file__, end='|', flush=True)\nprint(__file__)\n",
            "robot_blue/robot.py|robot_blue",
        ),
        "the debugger, in small letters on Windows": (
            "import bdb\nprint('<' + bdb.Bdb().canonic(__file__))\n",
            "<robot_blue/robot.py",
        ),
        "the folder's name": ("import os\nprint('in', os.getcwd())\n", "in robot_blue"),
        "bytes": ("import os, sys\nsys.stdout.buffer.write(os.fsencode(__file__) + b'!\\n')\n", "robot_blue/robot.py!"),
    }.values(),
)
def test_a_file_is_called_as_the_team_calls_it(tmp_path: Path, program: str, says: str) -> None:
    said = printed(tmp_path, program)
    assert says.replace("robot_blue/", FOLDER) in said
    for place in (tempfile.gettempdir() + os.sep, sys.prefix, sys.base_prefix, str(Path.home()) + os.sep):
        assert place not in said


def test_a_warning_shows_the_line_that_it_is_about(tmp_path: Path) -> None:
    said = printed(tmp_path, "import helper\nhelper.warn()\n", helper=HELPER)
    assert f'{FOLDER}helper.py:3: UserWarning: mind\n  warnings.warn("mind")' in said


HELPER = 'import warnings\ndef warn():\n    warnings.warn("mind")\n'


def test_a_program_sees_the_whole_path_of_its_files(tmp_path: Path) -> None:
    program = "import os\nassert os.path.isabs(__file__) and os.path.exists(os.getcwd())\nprint(len(__file__) > 30)\n"
    assert printed(tmp_path, program) == "True"


def test_paths_of_windows_are_short_also_as_errors_quote_them(monkeypatch: pytest.MonkeyPatch) -> None:
    windows = SimpleNamespace(sep="\\", path=ntpath, __file__="C:\\Python\\Lib\\os.py")
    monkeypatch.setattr(_traceback, "os", windows)
    names = _traceback.short_names("D:\\Temp\\rcj-1\\program", ["C:\\Python\\Lib\\site-packages"])
    path = "D:\\Temp\\rcj-1\\program\\robot1\\map.txt"
    for quoted, expected in {
        path: "robot1\\map.txt",
        repr(path): r"'robot1\\map.txt'",
        repr("D:\\Temp\\rcj-1\\x"): r"'~\\x'",
        repr("C:\\Python\\Lib\\site-packages\\a.py"): r"'site-packages\\a.py'",
        ntpath.normcase(path): "robot1\\map.txt",
        repr(ntpath.normcase(path)): r"'robot1\\map.txt'",
    }.items():
        assert reduce(lambda said, name: said.replace(*name), names, quoted) == expected


@pytest.mark.parametrize(
    ("prefix", "path", "expected"),
    [
        ("/home/somebody/python", "/home/somebody/python/lib/python311.zip", "python/lib/python311.zip"),
        ("/home/somebody/python", "/home/somebody/python", "python"),
        ("/usr", "/usr/lib/python311.zip", "/usr/lib/python311.zip"),  # tells nothing of whose computer it is
    ],
)
def test_the_folder_that_python_is_in_is_not_named(
    monkeypatch: pytest.MonkeyPatch, prefix: str, path: str, expected: str
) -> None:
    """It may lie in a user's home; a program that debugs a failing import prints `sys.path`."""
    monkeypatch.setattr(_traceback, "os", SimpleNamespace(sep="/", path=posixpath, __file__="/elsewhere/os.py"))
    monkeypatch.setattr(
        _traceback, "sys", SimpleNamespace(prefix=prefix, base_prefix=prefix, executable="/elsewhere/py")
    )
    monkeypatch.setattr(
        _traceback, "__file__", "_traceback.py"
    )  # of which no folder is known, as of Windows' seen from here
    names = _traceback.short_names("/tmp/rcj-1/program", [])
    assert reduce(lambda said, name: said.replace(*name), names, f"['{path}']") == f"['{expected}']"


def test_a_write_returns_its_full_length(tmp_path: Path) -> None:
    """A writer of bytes gets their number; with a smaller one it would write the rest once more."""
    program = "import sys\ndata = __file__.encode() * 1000\nprint(sys.stdout.buffer.write(data) == len(data))\n"
    assert printed(tmp_path, program) == f"{FOLDER}robot.py" * 1000 + "True"


def escaped(folder: Path) -> str:
    """As the interpreter writes it in a dump."""
    return str(folder).encode("ascii", "backslashreplace").decode()


NO_STACK_OF_C = "Current thread's C stack trace (most recent call first):\n  <cannot get C stack on this system>\n"
"""What Python 3.14 adds on Windows."""


@pytest.mark.parametrize(
    ("begins", "after", "is_end"),
    [
        ("Fatal Python error: Segmentation fault", "", True),
        ("Windows fatal exception: access violation", "", True),
        ("Windows fatal exception: stack overflow", "\nExtension modules: numpy._core (total: 1)\n", True),
        ("Windows fatal exception: access violation", f"\n{NO_STACK_OF_C}", True),
        ("Windows fatal exception: access violation", "caught\n", False),  # not its end: it goes on
    ],
)
def test_where_the_interpreter_broke_is_taken_from_the_end_of_the_log(
    tmp_path: Path, begins: str, after: str, is_end: bool
) -> None:
    log = ProgramLog(tmp_path / "Y1.log", 100_000, tmp_path)
    frames = f'  File "{escaped(tmp_path)}{os.sep}robot.py", line 4 in drive\n  File "controller{os.sep}robot.py", line 9 in step\n'
    dump = f"{begins}\n\nThread 0x00000130 (most recent call first):\n\nCurrent thread 0x00000124:\n{frames}{after}"
    os.write(log.fd, f"said before\n{dump}".encode())
    expected = log.take_dump(tmp_path)
    log.close()
    left = (tmp_path / "Y1.log").read_text(encoding="utf-8")
    assert expected == ('  File "robot.py", line 4 in drive\n' if is_end else "")
    assert left == ("said before\n" if is_end else f"said before\n{dump}")
