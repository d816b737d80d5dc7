"""Names that are not defined: a check says what to write only where what it says is so."""

from __future__ import annotations

import sys
from pathlib import PurePosixPath

import pytest

from rcj_challenges.checker.advice.unknown_names import on_unknown_name


def told(name, code, **others):
    """What is said of a crash over a name in the last line of ``robot.py``."""
    files = {PurePosixPath("team/robot.py"): code.encode()}
    files |= {PurePosixPath(f"team/{stem}.py"): text.encode() for stem, text in others.items()}
    detail = f"NameError: name '{name}' is not defined (team/robot.py, line {len(code.splitlines())})"
    return on_unknown_name(name, detail, files)


@pytest.mark.parametrize(
    ("name", "code", "line"),
    [
        ("math", "x = math.sin(1)", "import math"),
        ("time", "import math\nbegan = time.time()", "import time"),
        ("datetime", "now = datetime.now()", "from datetime import datetime"),
        ("datetime", "now = datetime.datetime.now()", "import datetime"),
        ("queue", "q = queue.Queue()", "import queue"),
        ("numpy", "x = numpy.zeros(3)", "import numpy"),
        ("atan2", "x = atan2(1, 2)", "from math import atan2"),
    ],
)
def test_what_is_not_imported_is_told_with_the_line_that_imports_it(name, code, line):
    assert told(name, code) == f'write "{line}" at the top of robot.py'


@pytest.mark.parametrize(
    ("name", "code"),
    [
        ("queue", "queue.append(1)"),  # a list of the team's own that is called like a module
        ("signal", "signal.strength = 3"),
        ("this", "this.speed = 3"),
        ("this", "x = this.s"),  # of Python, and prints a poem when it is imported
        ("socket", "socket.socket()"),  # which a match refuses
        ("self", "self.run()"),
        ("sqrt", "x = sqrt"),
        ("go", "go()"),
        ("log", "log('kick-off')"),  # a function of the team's own that is called like one of math
        ("log", 'log(f"ball at {x}")'),
        ("e", "e(3)"),  # a number
    ],
)
def test_what_is_no_such_module_is_not_taken_for_one(name, code):
    assert told(name, code) == ""


def test_a_function_of_the_file_beside_it_is_told_as_it_is_imported_there():
    utils = "def dist(a, b): return abs(a - b)\n"
    assert told("dist", "import utils\ndist(1, 2)", utils=utils) == "dist is in utils.py: write utils.dist(…)"
    assert told("dist", "import utils as u\ndist(1, 2)", utils=utils) == "dist is in utils.py: write u.dist(…)"
    written = 'write "from utils import dist" at the top of robot.py'
    assert told("dist", "from utils import x\ndist(1, 2)", utils=utils) == written


def test_a_function_of_another_file_is_not_taken_for_one_of_math_and_where_it_is_imported_from_is_not_guessed():
    dist = "def dist(a, b): return abs(a - b)\n"
    assert told("dist", "dist(1, 2)", utils=dist, tools=dist) == ""
    assert told("dist", "dist(1, 2)", utils=dist) == ""  # nobody imports by such a name here: it may be a package
    assert told("dist", "from utils import x\ndist(1, 2)", utils="import robot\n" + dist) == ""


def test_what_lies_in_another_folder_and_what_is_no_program_counts_for_nothing():
    other = {PurePosixPath("other/utils.py"): b"def dist(a, b): return abs(a - b)\n"}
    robot = {PurePosixPath("team/robot.py"): b"from utils import x\nfar(dist(1, 2))"}
    detail = "NameError: name 'dist' is not defined (team/robot.py, line 2)"
    assert on_unknown_name("dist", detail, other | robot) == ""
    notes = {PurePosixPath("team/notes.md"): b"def dist(a, b): of math\n"}
    assert on_unknown_name("dist", detail, notes | robot) == 'write "from math import dist" at the top of robot.py'


def test_a_function_that_is_defined_above_and_gone_is_not_told_to_be_moved_up():
    assert told("go", "def go(): pass\ndel go\ngo()") == ""


def test_a_method_is_told_to_be_called_as_one():
    code = "class Bot:\n    def turn(self): pass\n    def run(self):\n        turn()"
    assert told("turn", code).startswith("turn is a method: within its class it is called self.turn(…)")


def test_a_function_that_is_defined_below_is_told_to_be_moved_up():
    files = {PurePosixPath("robot.py"): b"main()\n\ndef main():\n    pass\n"}
    said = on_unknown_name("main", "NameError: name 'main' is not defined (robot.py, line 1)", files)
    assert said == "line 1 uses main before Python has read line 3, where it is defined: move that up"


def test_what_no_line_of_the_team_shows_is_not_guessed():
    assert on_unknown_name("math", "NameError: name 'math' is not defined", {}) == ""
    assert on_unknown_name("math", "NameError: name 'math' is not defined (other.py, line 3)", {}) == ""


@pytest.mark.parametrize("file", ["moves.pyw", "moves.txt"])
def test_a_program_in_a_file_of_another_ending_is_read_like_any(file):
    """On Windows ``import moves`` finds moves.pyw; anything can be read and executed."""
    files = {PurePosixPath(file): b"drive()\n", PurePosixPath("robot.py"): b"import moves\ndef drive(): pass\n"}
    detail = f"NameError: name 'drive' is not defined ({file}, line 1)"
    assert on_unknown_name("drive", detail, files) == ""
    files[PurePosixPath(file)] += b"def drive(): pass\n"
    moved = "line 1 uses drive before Python has read line 2, where it is defined: move that up"
    assert on_unknown_name("drive", detail, files) == moved


def test_a_module_that_this_computer_has_only_in_part_is_not_told(monkeypatch):
    """As of a Python that was built without a library, or ``crypt`` on Windows."""
    monkeypatch.delitem(sys.modules, "lzma", raising=False)
    monkeypatch.setitem(sys.modules, "_lzma", None)
    assert told("lzma", "x = lzma.compress(b'')") == ""


def test_a_file_of_the_current_folder_that_is_called_like_a_module_of_python_is_never_run(tmp_path, monkeypatch):
    ran = tmp_path / "ran"
    (tmp_path / "fileinput.py").write_text(f"open({str(ran)!r}, 'w').close()\ninput = 1\n", encoding="utf-8")
    monkeypatch.delitem(sys.modules, "fileinput", raising=False)
    monkeypatch.syspath_prepend(tmp_path)  # as `python -m` does with the current folder
    assert told("fileinput", "x = fileinput.input()") == ""
    assert not ran.exists()
