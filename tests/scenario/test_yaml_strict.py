"""YAML 1.2 scalars, and nothing that hides or refers."""

import json
import math
from unittest.mock import patch

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.scenario.errors import ScenarioError, place_of
from rcj_challenges.scenario.reading import yaml_strict
from rcj_challenges.scenario.reading.yaml_strict import MAX_DEPTH, parse_bytes, parse_text
from rcj_challenges.scenario.tree import Entries, Leaf, Mark, child, plain
from tests.scenario.writing import problems_of

BOTH_PARSERS = [yaml.SafeLoader, *([yaml.CSafeLoader] if yaml.__with_libyaml__ else [])]


def value(text):
    return plain(parse_text(f"key: {text}", "f.yaml"))["key"]


def complaints(text):
    with pytest.raises(ScenarioError) as caught:
        parse_text(text, "f.yaml")
    return [f"{place_of(one).line}:{place_of(one).column} {one.code}" for one in caught.value.diagnostics]


@pytest.mark.parametrize(
    "text", ["no", "on", "yes", "off", "NO", "y", "N", "12:30", "1:30:00", "2021-06-18", "<<", "="]
)
def test_what_yaml_1_1_takes_for_something_else_is_text(text):
    assert value(text) == text


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("0", 0), ("-0", 0), ("+7", 7), ("010", 10), ("0o17", 15), ("0x1F", 31), ("600", 600), ("-12", -12),
        ("1e3", 1000.0), ("1E-3", 0.001), ("-.5", -0.5), (".5", 0.5), ("1.", 1.0), ("+1.5e+2", 150.0), ("1_000", "1_000"),
        ("0b11", "0b11"), ("0x", "0x"), ("0o8", "0o8"), ("1e", "1e"), (".", "."), ("-", None), ("+", "+"), ("1.2.3", "1.2.3"),
        ("9223372036854775807", 2**63 - 1), ("-9223372036854775808", -(2**63)),
    ],
)  # fmt: skip
def test_numbers_are_those_of_yaml_1_2(text, number):
    if number is None:
        return
    found = value(text)
    assert found == number
    assert type(found) is type(number)


@pytest.mark.parametrize(("text", "word"), [("true", True), ("False", False), ("TRUE", True), ("tRUE", "tRUE")])
def test_true_and_false_are_the_only_booleans(text, word):
    assert value(text) is word or value(text) == word


@pytest.mark.parametrize("text", ["~", "null", "Null", "NULL"])
def test_a_written_null_is_not_an_empty_value(text):
    leaf = child(parse_text(f"key: {text}", "f"), "key")
    assert leaf == Leaf(None, Mark("f", 1, 6), empty=False)
    assert child(parse_text("key:", "f"), "key").empty
    assert not child(parse_text("key: ''", "f"), "key").empty


@pytest.mark.parametrize("text", [".inf", "-.Inf", "+.INF", ".nan", ".NaN", "1e999", "-1e400"])
def test_a_number_that_is_not_finite_is_refused(text):
    assert complaints(f"key: {text}") == ["1:6 invalid-yaml"]


@pytest.mark.parametrize("text", ["9223372036854775808", "1" * 5000, "0x" + "f" * 17])
def test_a_whole_number_over_64_bits_is_refused(text):
    assert complaints(f"key: {text}") == ["1:6 invalid-yaml"]


def test_every_key_and_value_keeps_its_line_and_column():
    tree = parse_text("a: 1\nb:\n  - x\n  - {c: [2, 3]}\n", "f.yaml")
    assert isinstance(tree, Entries)
    assert tree.key_marks["b"] == Mark("f.yaml", 2, 1)
    flow = child(tree.entries["b"], 1)
    assert flow.key_marks["c"] == Mark("f.yaml", 4, 6)
    assert child(flow.entries["c"], 1).mark == Mark("f.yaml", 4, 13)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a: 1\nb: 2\na: 3", "3:1 duplicate-key"),
        ('{a: 1, "a": 2}', "1:8 duplicate-key"),
        ("a: !x 1", "1:4 invalid-yaml"),
        ("a: &x 1", "1:4 invalid-yaml"),
        ("1: a", "1:1 invalid-yaml"),
        ("true: a", "1:1 invalid-yaml"),
        ("? [a]\n: b", "1:3 invalid-yaml"),
        ("? \n: b", "1:2 invalid-yaml"),
        ("a: 1\n---\nb: 2", "2:1 invalid-yaml"),
        ("%TAG ! tag:x,2000:\n---\na: 1", "1:1 invalid-yaml"),
        ("", "1:1 empty-file"),
        ("# nothing\n", "1:1 empty-file"),
    ],
)
def test_what_strict_yaml_refuses(text, expected):
    assert complaints(text) == [expected]


def test_a_yaml_1_2_directive_is_harmless():
    assert plain(parse_text("%YAML 1.2\n---\na: 1\n...\n", "f")) == {"a": 1}


def test_aliases_are_refused_before_anything_is_built_from_them():
    bomb = "a: &a [x, x]\n" + "".join(f"k{i}: &k{i} [*a, *a, *a, *a, *a, *a, *a, *a]\n" for i in range(1000))
    found = complaints(bomb)
    assert len(found) == 3
    assert found[-1] == "2:10 invalid-yaml"


def test_nesting_has_a_limit():
    inside = MAX_DEPTH - 1
    assert parse_text("a: " + "[" * inside + "]" * inside, "f")
    assert complaints("a: " + "[" * MAX_DEPTH + "]" * MAX_DEPTH) == [f"1:{MAX_DEPTH + 3} invalid-yaml"]
    assert len(complaints("\n".join(" " * i + "a:" for i in range(500)))) == 1


def test_windows_files_read_the_same():
    text = "a: 1\nb:\n  - größer\n"
    windows = parse_bytes(b"\xef\xbb\xbf" + text.replace("\n", "\r\n").encode(), "f")
    assert windows == parse_bytes(text.encode(), "f")


# --- properties -------------------------------------------------------------------------------------------------------

NASTY = st.text(alphabet="abx10.-+:,{}[]&*!?|>'\"%@`#~ \n\t\r\\éß\ufeff\u2028\x85", max_size=60)
# YAML escapes characters beyond the basic plane otherwise than JSON does.
BASIC = st.text(st.characters(max_codepoint=0xFFFF, exclude_categories=["Cs"]), max_size=12)
SCALARS = st.none() | st.booleans() | st.integers(-(2**63), 2**63 - 1) | BASIC
FINITE = st.floats(allow_nan=False, allow_infinity=False)
JSON_LIKE = st.recursive(
    SCALARS | FINITE,
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(BASIC, inner, max_size=4),
    max_leaves=12,
)


@given(st.text(max_size=80) | NASTY)
def test_any_text_is_either_read_or_refused_with_a_place(text):
    for problem in problems_of(parse_text, text, "f.yaml"):
        assert place_of(problem).line >= 1
        assert place_of(problem).column >= 1
        assert problem.message


@given(st.binary(max_size=60))
def test_any_bytes_are_either_read_or_refused(data):
    assert all(problem.message for problem in problems_of(parse_bytes, data, "f.yaml"))


@given(JSON_LIKE)
def test_json_is_read_as_json_means_it(data):
    found = plain(parse_text(json.dumps(data, ensure_ascii=True), "f"))
    assert json.dumps(found) == json.dumps(data)


@given(st.lists(st.text(st.characters(exclude_categories=["Cs"]), max_size=20), max_size=4), st.sampled_from("'\""))
def test_any_text_in_quotes_is_read_back(texts, quote):
    found = plain(parse_text(yaml.safe_dump(texts, default_style=quote), "f"))
    assert found == texts


@given(FINITE | st.integers(-(2**63), 2**63 - 1))
def test_numbers_survive_being_written_and_read(number):
    found = value(repr(number))
    assert type(found) is type(number)
    assert found == number
    assert math.copysign(1, found) == math.copysign(1, number)


def outcome(text, loader):
    try:
        with patch.object(yaml_strict, "_LOADER", loader):
            return parse_text(text, "f")
    except ScenarioError as error:
        return error.diagnostics


@pytest.mark.skipif(len(BOTH_PARSERS) == 1, reason="PyYAML was built without libyaml here")
@given(JSON_LIKE)
def test_both_parsers_of_pyyaml_give_the_same_tree(data):
    for text in (json.dumps(data, indent=1), yaml.safe_dump(data, allow_unicode=False)):
        slow, fast = (outcome(text, loader) for loader in BOTH_PARSERS)
        assert slow == fast
