"""Any bytes as a Python file are read to an end."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.checker.reader import read_source


@given(st.binary(max_size=400) | st.text(max_size=200).map(lambda text: text.encode("utf-8", "replace")))
def test_any_bytes_are_read_to_an_end(source):
    found = read_source(source, "robot.py")
    assert ("wrong" in found) != ("imports" in found)


WORDS = st.sampled_from(
    ["import ", "from ", ".", "a", "b", " as ", ",", "*", "try:", "except ", "ImportError:", "\n", "    ", "(", ")",
     "if TYPE_CHECKING:", "with suppress(", "sys.path", "__import__('x.y')", "__import__('')", "async ", "def f():"]
)  # fmt: skip


@given(st.lists(WORDS, max_size=30).map("".join))
def test_any_words_of_python_are_read_to_an_end(text):
    found = read_source(text.encode(), "robot.py")
    assert all(one["line"] >= 1 for one in found.get("imports", ()))
