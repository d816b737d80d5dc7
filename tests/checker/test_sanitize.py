"""Names and output of strangers move nothing and hide nothing, wherever they are shown."""

from __future__ import annotations

import unicodedata

from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.core.sanitize import MAX_CHARACTERS, sanitize, sanitize_block

ANYTHING = st.text(st.characters(codec=None, categories=None))


def harmless(line: str) -> bool:
    return all(letter == "\u200d" or unicodedata.category(letter)[0] != "C" for letter in line)


def test_terminal_escapes_and_direction_marks_are_spelled_out():
    assert sanitize("a\x1b[2J\u202eb") == "a\\x1b[2J\\u202eb"
    assert sanitize("one\ntwo\rthree\x85\u2028") == "one\\ntwo\\rthree\\x85\\u2028"
    assert sanitize("\U000e0041") == "\\U000e0041"


def test_ordinary_names_in_any_script_and_emoji_stay_as_they_are():
    for name in ("Häns & Gretel", "ロボット", "ﺭﻮﺑﻮﺗ", "👩‍🔧 crew", '<b>"quoted"</b>'):
        assert sanitize(name) == name


def test_what_is_too_long_is_cut_in_the_middle():
    cut = sanitize("a" * 1000 + "the_end.py")
    assert len(cut) == MAX_CHARACTERS
    assert cut.startswith("aaa")
    assert cut.endswith("the_end.py")
    assert "…" in cut


def test_bytes_that_are_no_text_are_shown_as_escapes():
    assert sanitize(b"\xff\xfeok") == "\\xff\\xfeok"


def test_a_tower_of_accents_ends():
    assert sanitize("Z" + "\u0301" * 100) == "Z" + "\u0301" * 4


@given(ANYTHING, st.integers(20, 300))
def test_whatever_it_is_it_becomes_one_harmless_line_that_can_be_encoded(text, longest):
    line = sanitize(text, longest)
    assert harmless(line)
    assert len(line) <= longest
    line.encode("utf-8")


@given(ANYTHING)
def test_whatever_a_program_printed_each_of_its_lines_is_harmless(text):
    assert all(map(harmless, sanitize_block(text, 8).split("\n")))


def test_of_a_long_output_the_beginning_and_the_end_are_kept():
    block = sanitize_block("\n".join(map(str, range(1000))), 8).split("\n")
    assert block[:2] == ["0", "1"]
    assert block[2] == "… 992 lines left out …"
    assert block[-1] == "999"
