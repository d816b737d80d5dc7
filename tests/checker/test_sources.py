"""Stage *sources*: Python that can run here, and everything imported is there; nothing of it is run."""

from __future__ import annotations

import sys

import pytest

from rcj_challenges.checker.reading import MAX_BYTES
from rcj_challenges.checker.sources import check_sources
from rcj_challenges.scenario.load import load
from rcj_challenges.submissions.team import open_team

FOLDER = "rcj_soccer_team_blue"
ENTRY = f"{FOLDER}/rcj_soccer_team_blue.py"
ENTRANTS = tuple(load("match").scenario.entrants.values())


@pytest.fixture
def check(tmp_path):
    def check_files(program, **others):
        files = {ENTRY: program} | {name.replace("__", "/") + ".py": text for name, text in others.items()}
        return check_paths(files)

    def check_paths(files):
        for name, text in files.items():
            path = tmp_path / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return check_sources(open_team(tmp_path, *ENTRANTS))

    check_files.paths = check_paths
    return check_files


def codes(stage, level=None):
    return [finding.code.removeprefix("sources.") for finding in stage.findings if level in (None, finding.level)]


def only(stage):
    (finding,) = stage.findings
    return finding


def test_a_failure_is_shown_however_many_warnings_there_are(check):
    hidden = [name for name in sorted(sys.stdlib_module_names) if not name.startswith("_")][:60]
    stage = check("import nowhere\n", **{f"{FOLDER}__{name}": "x = 1\n" for name in hidden})
    assert codes(stage, "error") == ["missing_module"]
    assert len(codes(stage, "warning")) == 40


def test_a_program_that_imports_what_there_is_passes(check):
    stage = check(
        "import math, numpy.linalg, scipy\nfrom controller import Robot\nimport robot1, shared.tools\n",
        rcj_soccer_team_blue__robot1="from utils import go\n",
        rcj_soccer_team_blue__utils="go = 1\n",
        shared__tools="from . import more\n",
        shared__more="from .tools import x\n",
    )
    assert codes(stage) == ["ok"]
    assert stage.level == "passed"


@pytest.mark.parametrize("imported", ["import lib.plan", "from lib import plan", "from lib.plan import go"])
def test_what_is_imported_out_of_a_folder_is_read_too(check, imported):
    found = only(check(f"{imported}\n", rcj_soccer_team_blue__lib__plan="go = 1\nimport nowhere\n"))
    assert (found.code, found.where) == ("sources.missing_module", f"{FOLDER}/lib/plan.py:2:1")


def test_a_syntax_error_is_reported_with_file_line_and_column(check):
    found = only(check("x = 1\nif x == 2\n    pass\n"))
    assert (found.code, found.level) == ("sources.syntax", "error")
    assert found.where == f"{ENTRY}:2:10"
    assert "expected ':'" in found.message
    assert found.help


WRONG = {
    "python 2": (b"print 'hello'\n", "syntax", "Python 2"),
    "tabs and spaces": (b"if 1:\n\tx = 1\n        y = 2\n", "syntax", "spaces"),
    "indentation": (b"def f():\nreturn 1\n", "syntax", "indented"),
    "zero bytes": (b"x = 1\n\0\n", "null_bytes", "UTF-8"),
    "utf-16": ("x = 1\n".encode("utf-16"), "null_bytes", "UTF-8"),
    "latin-1 letters": (b"x = '\xe4'\n", "encoding", "UTF-8"),
    "an encoding that does not exist": (b"# -*- coding: klingon -*-\n", "encoding", "UTF-8"),
    "too many brackets": (b"x = " + b"(" * 5000 + b")" * 5000, "too_deep", "smaller"),
    "a sum without end": (b"x = " + b"+".join([b"1"] * 30_000), "too_deep", "smaller"),
    "lists without end": (b"x = " + b"[" * 150 + b"]" * 150 + b"\n" + b"y=" + b"{" * 50_000, "too_deep", "smaller"),
    "quotation marks of a text": ("speed = “fast”\n".encode(), "syntax", "type it on the keyboard"),
    "a blank without width": ("speed\u200b = 5\n".encode(), "syntax", "type it on the keyboard"),
    "nothing": (b"# later\n", "empty", "put your program"),
}


@pytest.mark.parametrize(("source", "code", "help_"), WRONG.values(), ids=WRONG)
def test_a_program_that_is_no_python_fails_with_help(check, source, code, help_):
    found = only(check(source))
    assert (found.code, found.level) == (f"sources.{code}", "error")
    assert help_ in found.help


@pytest.mark.parametrize(
    "source",
    [
        b"\xef\xbb\xbfx = '\xc3\xa4'\r\n",
        b"# -*- coding: latin-1 -*-\nx = '\xe4'\n",
        b"x = 1\r\ny = 2\r\n",
        b"x = '\\d'\n",
    ],
    ids=["a byte order mark", "an encoding cookie", "Windows line ends", "a strange escape"],
)
def test_what_python_reads_is_in_order(check, source):
    assert codes(check(source)) == ["ok"]


def test_a_broken_file_that_no_program_uses_is_only_a_warning(check):
    stage = check("import robot1\n", rcj_soccer_team_blue__robot1="", rcj_soccer_team_blue__old="x = (\n")
    assert codes(stage, "warning") == ["syntax"]
    assert "no program seems to use" in only(stage).message
    assert stage.level == "warning"


def test_a_huge_file_is_not_looked_into(check):
    stage = check("import data\n", rcj_soccer_team_blue__data="x = 1\n" + "#" * MAX_BYTES)
    assert codes(stage) == ["large"]
    assert stage.level == "warning"


def test_a_module_that_is_nowhere_fails(check):
    found = only(check("x = 1\nimport cv2\n"))
    assert (found.code, found.level, found.where) == ("sources.missing_module", "error", f"{ENTRY}:2:1")
    assert '"cv2"' in found.message


def test_the_nearest_name_is_suggested(check):
    assert 'did you mean "utils"?' in only(check("import util\n", rcj_soccer_team_blue__utils="")).help
    found = only(check("import robot3\n", rcj_soccer_team_blue__robot2=""))
    assert found.help.startswith("put robot3.py beside the program")


@pytest.mark.parametrize("beside", ["tools.py", "tools/speeds.py"])
def test_a_module_beside_a_single_program_is_there_and_was_not_given(tmp_path, beside):
    (tmp_path / "robot.py").write_text("import tools\n", encoding="utf-8")
    (tmp_path / beside).parent.mkdir(exist_ok=True)
    (tmp_path / beside).write_text("", encoding="utf-8")
    found = only(check_sources(open_team(tmp_path / "robot.py", *ENTRANTS)))
    assert (found.code, found.level) == ("sources.missing_module", "error")
    assert found.help == (
        f"{beside.partition('/')[0]} lies beside robot.py, but only that one file was given: "
        "give the folder in which both lie"
    )


def test_a_module_with_an_ending_that_windows_hides_is_named(check):
    stage = check.paths({ENTRY: "import tools\n", f"{FOLDER}/tools.py.txt": "speed = 3\n"})
    assert only(stage).code == "sources.missing_module"
    assert only(stage).help == f"call {FOLDER}/tools.py.txt tools.py: Windows hides the last ending"


def test_capital_and_small_letters_count(check):
    found = only(check("import Utils\n", rcj_soccer_team_blue__utils=""))
    assert found.code == "sources.wrong_case"
    assert '"utils"' in found.help


def test_a_module_where_python_does_not_look_is_named(check):
    found = only(check("import helper\n", rcj_soccer_team_blue__lib__helper=""))
    assert found.code == "sources.elsewhere"
    assert f"{FOLDER}/lib/helper.py" in found.message


def test_a_program_that_changes_sys_path_may_import_from_any_of_its_folders(check):
    program = "import os, sys\nsys.path.append(os.path.join(os.path.dirname(__file__), 'lib'))\nimport helper\n"
    assert codes(check(program, rcj_soccer_team_blue__lib__helper="")) == ["ok"]


def test_the_layout_of_2021_finds_its_libraries_in_the_folder_above(check):
    entry = "import sys\nsys.path.append('..')\nfrom team_123_libraries.robot1.player import play\n"
    stage = check.paths(
        {
            **{f"robot{number}/robot{number}.py": entry for number in (1, 2, 3)},
            "team_123_libraries/robot1/player.py": "from .tools import x\nplay = 1\n",
            "team_123_libraries/robot1/tools.py": "x = 1\n",
        }
    )
    assert codes(stage) == ["ok"]


def test_a_part_that_is_missing_from_a_folder_fails(check):
    stage = check("import lib.tools\nfrom lib import nothing\nimport robot1.x\n", rcj_soccer_team_blue__lib__other="", rcj_soccer_team_blue__robot1="",
    )  # fmt: skip
    assert codes(stage, "error") == ["missing_part"] * 3


def test_names_taken_from_an_init_file_are_not_looked_for_as_files(check):
    stage = check.paths({ENTRY: "from lib import anything\n", f"{FOLDER}/lib/__init__.py": "anything = 1\n"})
    assert codes(stage) == ["ok"]


@pytest.mark.parametrize("where", ["rcj_soccer_team_blue__robot1", "rcj_soccer_team_blue__lib__a"])
def test_dots_that_lead_out_of_packages_fail(check, where):
    stage = check("import robot1, lib.a\n" if "robot1" in where else "import lib.a\n", **{where: "from ... import b\n"})
    assert "relative_import" in codes(stage, "error")


GUARDED = {
    "ImportError": "try:\n    import torch\nexcept ImportError:\n    torch = None\n",
    "one of several": "try:\n    import torch\nexcept (OSError, ModuleNotFoundError):\n    torch = None\n",
    "anything": "try:\n    import torch\nexcept:\n    torch = None\n",
    "suppress": "from contextlib import suppress\nwith suppress(ImportError):\n    import torch\n",
}


@pytest.mark.parametrize("program", GUARDED.values(), ids=GUARDED)
def test_a_missing_module_that_the_program_is_ready_for_is_a_warning(check, program):
    stage = check(program)
    assert codes(stage) == ["missing_module"]
    assert stage.level == "warning"


def test_a_try_that_catches_something_else_does_not_help(check):
    assert codes(check("try:\n    import torch\nexcept OSError:\n    pass\n")) == ["missing_module"]
    assert codes(check("try:\n    pass\nexcept ImportError:\n    import torch\n")) == ["missing_module"]


ONLY_IF_REACHED = {
    "under if": "DEBUG = False\nif DEBUG:\n    import torch\n",
    "under else": "import math\nif math:\n    pass\nelse:\n    import torch\n",
    "in a function": "def show():\n    import torch\n",
    "in a method": "class Robot:\n    def show(self):\n        import torch\n",
    "in a for loop": "for _ in ():\n    import torch\n",
    "in a while loop": "while False:\n    import torch\n",
    "after the main loop": "while True:\n    pass\nimport torch\n",
    "in a try": "try:\n    open('debug')\n    import torch\nexcept OSError:\n    pass\n",
    "in a match": "match 1:\n    case 2:\n        import torch\n",
}


@pytest.mark.parametrize("program", ONLY_IF_REACHED.values(), ids=ONLY_IF_REACHED)
def test_a_missing_module_that_is_imported_only_if_the_program_comes_there_is_a_warning(check, program):
    found = only(check(program))
    assert (found.code, found.level) == ("sources.missing_module", "warning")
    assert "only if it is reached" in found.message


CERTAIN = {
    "in a class": "class Robot:\n    import torch\n",
    "in a with": "import warnings\nwith warnings.catch_warnings():\n    import torch\n",
    "after a for loop": "import sys\nfor folder in ('a', 'b'):\n    sys.path.append(folder)\nimport torch\n",
    "after a function with a loop": "def play():\n    while True:\n        pass\nimport torch\n",
    "in the end": "try:\n    pass\nfinally:\n    import torch\n",
    "after what may fail": "try:\n    import numba\nexcept ImportError:\n    pass\nimport torch\n",
}


@pytest.mark.parametrize("program", CERTAIN.values(), ids=CERTAIN)
def test_a_missing_module_that_is_imported_at_once_fails(check, program):
    assert codes(check(program), "error") == ["missing_module"]


def test_what_a_file_needs_that_may_never_be_imported_is_a_warning(check):
    stage = check("def show():\n    import screen, broken\n", rcj_soccer_team_blue__screen="import torch\n",
                  rcj_soccer_team_blue__broken="x = (\n")  # fmt: skip
    assert sorted(codes(stage)) == ["missing_module", "syntax"]
    assert stage.level == "warning"
    assert any("only running the programs can show" in found.message for found in stage.findings)


def test_a_file_that_needs_a_missing_module_may_be_done_without(check):
    stage = check("try:\n    import fast\nexcept ImportError:\n    pass\n", rcj_soccer_team_blue__fast="import torch\n")
    assert codes(stage) == ["missing_module"]


def test_a_file_that_is_imported_for_certain_as_well_still_fails(check):
    program = "def show():\n    import screen\ntry:\n    import screen\nexcept ImportError:\n    pass\nimport shapes\n"
    stage = check(
        program, rcj_soccer_team_blue__screen="import torch\n", rcj_soccer_team_blue__shapes="import screen\n"
    )
    assert codes(stage) == ["missing_module"]


@pytest.mark.parametrize("marker", ["<<<<<<< HEAD", ">>>>>>> main"])
def test_what_git_left_in_a_file_is_reported(check, marker):
    (found,) = check(f"x = 1\n{marker}\ny = 2\n").findings
    assert found.code == "sources.syntax"
    assert "git" in found.help
    assert found.where.endswith(":2:1")


def test_modules_whose_use_is_refused_are_a_warning(check):
    stage = check("import socket, subprocess\nimport urllib.request\nfrom http import server\nimport urllib.parse\n")
    assert codes(stage) == ["refused_module"] * 4
    assert stage.level == stage.findings[0].code.level == "warning"
    assert "the network" in stage.findings[0].message


def test_a_part_of_python_that_this_computer_lacks_fails(check):
    absent = "winreg" if sys.platform != "win32" else "pwd"
    assert codes(check(f"import {absent}\n"), "error") == ["not_on_this_computer"]


@pytest.mark.parametrize(
    ("name", "code"),
    [
        ("random", "shadows"),
        ("numpy", "shadows"),
        ("sys", "passed_over"),
        ("os", "passed_over"),
        ("controller", "passed_over"),
    ],
)
def test_a_file_with_the_name_of_a_module_of_python_is_a_warning(check, name, code):
    found = only(check("x = 1\n", **{f"rcj_soccer_team_blue__{name}": ""}))
    assert (found.code, found.level, found.where) == (f"sources.{code}", "warning", f"{FOLDER}/{name}.py")


def test_what_is_wrong_in_a_file_that_python_may_never_read_is_no_failure(check):
    stage = check(
        "import types, sys\n", rcj_soccer_team_blue__types="import cv2\n", rcj_soccer_team_blue__sys="import cv2\n"
    )
    assert codes(stage, "error") == []


@pytest.mark.parametrize(
    ("program", "level"),
    [
        ("import plan\n", "error"),
        ("try:\n    import plan\nexcept SyntaxError:\n    plan = None\n", "warning"),
        ("try:\n    import plan\nexcept Exception:\n    plan = None\n", "warning"),
        ("try:\n    import plan\nexcept SyntaxError:\n    pass\nimport plan\n", "error"),
    ],
)
def test_a_broken_file_fails_unless_its_error_may_be_caught(check, program, level):
    found = only(check(program, rcj_soccer_team_blue__plan="def f(:\n"))
    assert (found.code, found.level) == ("sources.syntax", level)


def test_many_missing_modules_are_reported_together(check):
    stage = check("".join(f"import nowhere_{number}\n" for number in range(300)))
    assert codes(stage)[:2] == ["missing_module", "missing_module"]
    assert codes(stage)[-1] == "more"


def test_a_circle_of_imports_ends(check):
    stage = check("import a\n", rcj_soccer_team_blue__a="import b\n", rcj_soccer_team_blue__b="import a\n")
    assert codes(stage) == ["ok"]


def test_nothing_of_a_program_is_run(check, tmp_path):
    check(f"open({str(tmp_path / 'trace')!r}, 'w')\nraise SystemExit\n")
    assert not (tmp_path / "trace").exists()


def test_strange_names_are_shown_safely(check):
    stage = check.paths({ENTRY: "x = 1\n", f"{FOLDER}/\u202e&b;.py": "x = (\n"})
    assert "\\u202e&b;.py" in only(stage).where


@pytest.mark.parametrize(
    "trick",
    [
        "import sys, tools\nsys.modules['werkzeug'] = tools\n",
        "import sys\nsys.path.insert(0, 'lib.zip')\n",
        "open('werkzeug.py', 'w').write('x = 1')\n",
    ],
)
def test_missing_module_of_a_program_that_makes_modules_itself_is_a_warning(check, trick):
    stage = check(trick + "import werkzeug\n", rcj_soccer_team_blue__tools="x = 1\n")
    assert codes(stage) == ["missing_module"]
    assert only(stage).level == "warning"


def test_threads_of_multiprocessing_are_allowed(check):
    stage = check("from multiprocessing.pool import ThreadPool\nimport multiprocessing.dummy\n")
    assert codes(stage, "warning") == []
