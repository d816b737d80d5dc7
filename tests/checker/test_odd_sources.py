"""Stage *sources*, of what is hardly Python or was once: any bytes, Python 2, modules that programs make themselves."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.checker.modules import Library
from rcj_challenges.checker.reader import read_source
from tests.checker import test_sources
from tests.checker.test_sources import codes, only

check = test_sources.check


@pytest.mark.parametrize(
    "trick",
    [
        "import sys, tools\nsys.modules['werkzeug'] = tools\n",
        "import sys\nsys.path.insert(0, 'lib.zip')\n",
        "open('werkzeug.py', 'w').write('x = 1')\n",
    ],
)
def test_of_a_program_that_makes_modules_itself_only_running_tells_what_is_missing(check, trick):
    stage = check(trick + "import werkzeug\n", rcj_soccer_team_blue__tools="x = 1\n")
    assert codes(stage) == ["conditional_missing_module"]
    assert only(stage).level == "warning"
    assert "only running the programs can show" in only(stage).message


@pytest.mark.parametrize("moved", ["import sys as s\ns.path.append('lib')\n", "exec(open('paths.txt').read())\n"])
def test_sys_path_may_be_changed_under_another_name_or_by_a_file_that_is_run(check, moved):
    assert codes(check(moved + "import tools\n", rcj_soccer_team_blue__lib__tools="x = 1\n")) == ["ok"]


@given(st.binary(max_size=400) | st.text(max_size=200).map(lambda text: text.encode("utf-8", "replace")))
def test_any_bytes_are_read_to_an_end(source):
    said = read_source(source, "robot.py")
    assert ("error" in said) != ("imports" in said)


WORDS = st.sampled_from(
    ["import ", "from ", ".", "a", "b", " as ", ",", "*", "try:", "except ", "ImportError:", "\n", "    ", "(", ")",
     "if TYPE_CHECKING:", "with suppress(", "sys.path", "__import__('x.y')", "__import__('')", "async ", "def f():"]
)  # fmt: skip


@given(st.lists(WORDS, max_size=30).map("".join))
def test_any_words_of_python_are_read_to_an_end(text):
    said = read_source(text.encode(), "robot.py")
    assert all(found["line"] >= 1 for found in said.get("imports", ()))


def test_for_hundreds_of_modules_that_are_nowhere_not_all_files_are_looked_through_each_time(check, monkeypatch):
    looked = []
    names = Library.names
    monkeypatch.setattr(Library, "names", lambda library: looked.append(library) or names(library))
    stage = check("".join(f"import nowhere_{number}\n" for number in range(300)))
    assert codes(stage)[:2] == ["missing_module", "missing_module"]
    assert "260 more of the kind" in stage.findings[-1].message
    assert len(looked) < 300
