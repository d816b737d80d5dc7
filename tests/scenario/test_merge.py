"""How a scenario and its base become one."""

import json

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.reading.merge import Merger
from rcj_challenges.scenario.reading.yaml_strict import parse_text
from rcj_challenges.scenario.tree import Entries, plain
from tests.scenario.writing import complaints


def merged(*texts):
    """Merge texts, the outermost base first; returns plain data and the merger."""
    merger = Merger()
    tree = parse_text("{}", "empty")
    assert isinstance(tree, Entries)
    for text in texts:
        merger.merge(tree, parse_text(text, "f"), Scenario)
    return plain(tree), merger


def test_mappings_merge_by_key_and_keep_the_rest_of_the_base():
    data, _ = merged("match: {halves: 2, half_s: 600}", "match: {half_s: 60}")
    assert data == {"match": {"halves": 2, "half_s": 60}}


def test_overridden_entries_keep_the_place_of_the_base_and_new_ones_follow():
    base = "rules: {a: {priority: 1}, b: {priority: 2}, c: {priority: 3}}"
    data, _ = merged(base, "rules: {new: {priority: 9}, b: {priority: 7}}")
    assert list(data["rules"]) == ["a", "b", "c", "new"]
    assert data["rules"]["b"] == {"priority": 7}


@pytest.mark.parametrize(
    ("over", "left"),
    [
        ("robots: {B1: null}", {"blue": {"robots": {"B2": "b.py"}}, "yellow": {"robots": {"Y1": "y.py"}}}),
        ("robots: {B1: null, B2: null}", {"yellow": {"robots": {"Y1": "y.py"}}}),
        ("robots: {B1: null, B2: null}, entrants: {blue: null}", {"yellow": {"robots": {"Y1": "y.py"}}}),
        ("robots: {B1: null}, entrants: {blue: {robots: {B1: null}}, yellow: {title: Y}}",
         {"blue": {"robots": {"B2": "b.py"}}, "yellow": {"robots": {"Y1": "y.py"}, "title": "Y"}}),
        # What the file itself says of a removed robot, or of an entrant without robots, is not taken away silently.
        ("robots: {B1: null}, entrants: {blue: {robots: {B1: c.py}}}",
         {"blue": {"robots": {"B1": "c.py", "B2": "b.py"}}, "yellow": {"robots": {"Y1": "y.py"}}}),
        ("robots: {B1: null, B2: null}, entrants: {blue: {title: B}}",
         {"blue": {"robots": {}, "title": "B"}, "yellow": {"robots": {"Y1": "y.py"}}}),
    ],
)  # fmt: skip
def test_removed_robots_leave_the_entrants_of_the_base_and_entrants_without_robots_go(over, left):
    base = "robots: {B1: {}, B2: {}, Y1: {}}\n"
    base += "entrants: {blue: {robots: {B1: b.py, B2: b.py}}, yellow: {robots: {Y1: y.py}}}"
    data, merger = merged(base, f"{{{over}}}")
    assert data["entrants"] == left
    assert merger.problems == []


@pytest.mark.parametrize(("base", "over"), [("entity: ball", "per: robots"), ("per: robots", "entity: ball")])
def test_of_keys_of_which_one_is_given_the_written_one_takes_the_place_of_that_of_the_base(base, over):
    data, _ = merged(f"sequences: {{s: {{{base}, cyclic: true}}}}", f"sequences: {{s: {{{over}}}}}")
    assert data == plain(parse_text(f"sequences: {{s: {{{over}, cyclic: true}}}}", "f"))


@pytest.mark.parametrize(
    ("base", "over"),
    [
        ("zones: {z: {shape: rect, x_min_m: 0, inverted: true}}", "zones: {z: {shape: circle, radius_m: 1}}"),
        ("obstacles: {o: {shape: box, size_m: [1, 1]}}", "obstacles: {o: {shape: cylinder, radius_m: 1}}"),
        ("kits: {k: {devices: {d: {device: gps, noise_m: 1}}}}", "kits: {k: {devices: {d: {device: lidar}}}}"),
        ("broadcast: {fields: {f: {counter: a, entity: b}}}", "broadcast: {fields: {f: {flag: c}}}"),
        ("broadcast: {fields: {f: {counter: a}}}", "broadcast: {fields: {f: {param: p}}}"),
        ("broadcast: {fields: {f: {counter: a}}}", "broadcast: {fields: {f: text}}"),
        ("broadcast: {fields: {f: text}}", "broadcast: {fields: {f: {counter: a}}}"),
    ],
)
def test_an_entry_of_another_kind_replaces_the_whole_entry_of_the_base(base, over):
    assert merged(base, over)[0] == plain(parse_text(over, "f"))


@pytest.mark.parametrize("over", ["{x_max_m: 2}", "{shape: rect, x_max_m: 2}"])
def test_an_entry_of_the_same_kind_merges(over):
    data, _ = merged("zones: {z: {shape: rect, x_min_m: 0}}", f"zones: {{z: {over}}}")
    assert data["zones"]["z"] == {"shape": "rect", "x_min_m": 0, "x_max_m": 2}


def test_entries_that_are_called_like_a_kind_are_just_names():
    data, _ = merged("spots: {point: {x_m: 1}, shape: {x_m: 2}}", "spots: {shape: {y_m: 3}}")
    assert data == {"spots": {"point": {"x_m": 1}, "shape": {"x_m": 2, "y_m": 3}}}
    data, _ = merged("params: {shape: a, trigger: b}", "params: {shape: c}")
    assert data == {"params": {"shape": "c", "trigger": "b"}}


def test_null_removes_a_named_entry_and_its_place_is_remembered():
    data, merger = merged("robots: {B1: {number: 1}, B2: {number: 2}}", "robots: {B1: null}")
    assert data == {"robots": {"B2": {"number": 2}}}
    assert ("robots", "B1") in merger.removed
    assert not merger.problems


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("match:\n", "missing-value match"),
        ("robots: {B1: }\n", "missing-value robots.B1"),
        ("match: {half_s: null}\n", "wrong-null match.half_s"),
        ("broadcast: null\n", "wrong-null broadcast"),
        ("robots: null\n", "wrong-null robots"),
        ("expect: null\n", "wrong-null expect"),
        ("counters: null\n", "wrong-null counters"),
        ("groups: {g: [B1, ~]}\n", "missing-value groups.g[1]"),
        ("rules: {r: null}\n", "wrong-null rules.r"),
        ("zones: {pich: null}\n", "wrong-null zones.pich -> pitch"),
    ],
)
def test_an_empty_value_is_a_mistake_and_null_only_removes_what_the_base_has(body, expected):
    assert complaints(body) == [expected]


TREES = st.recursive(
    st.integers(0, 9) | st.text("ab", max_size=2),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.sampled_from("abcd"), inner, max_size=4),
    max_leaves=12,
)
MAPPINGS = st.dictionaries(st.sampled_from(["rules", "zones", "params", "match"]), TREES, max_size=4)


def expected(base, over):
    if not (isinstance(base, dict) and isinstance(over, dict)):
        return over
    return {**base, **{key: expected(base[key], value) if key in base else value for key, value in over.items()}}


@given(MAPPINGS, MAPPINGS)
def test_merging_is_the_plain_recursive_merge_where_no_kinds_are_involved(base, over):
    found, merger = merged(json.dumps(base), json.dumps(over))
    assert found == expected(base, over)
    assert json.dumps(found) == json.dumps(expected(base, over))
    assert not merger.problems
