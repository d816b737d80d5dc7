"""Halves of different length: what is read, what is refused, what checks and tests take for the length of a half."""

import pytest

from rcj_challenges.core.diagnostics import InFile
from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.errors import ScenarioError, place_of
from rcj_challenges.scenario.halves import half_length_s, half_lengths_s, longest_half_s
from rcj_challenges.scenario.load import load
from tests.scenario.writing import HEAD, complaints, errors, in_tuples, loaded, rule, scenario


@pytest.mark.parametrize(
    ("match", "lengths_s"),
    [
        ("{half_s: 20}", (20,)),
        ("{halves: 3, half_s: 20}", (20, 20, 20)),
        ("{halves: 2, half_s: [20, 10]}", (20, 10)),
        ("{half_s: [20]}", (20,)),
    ],
)
def test_each_half_has_its_length(match, lengths_s):
    section = scenario(f"match: {match}\n").match
    assert half_lengths_s(section) == lengths_s
    assert [half_length_s(section, half) for half in range(1, len(lengths_s) + 1)] == list(lengths_s)
    assert longest_half_s(section) == max(lengths_s)


@pytest.mark.parametrize(
    ("overrides", "lengths_s"),
    [
        (["match.half_s=5"], (5, 5)),
        (["match.halves=1"], (20,)),
        (["match.halves=3"], (20, 10, 10)),
        (["match.half_s=[3, 4]"], (3, 4)),
        (["match.half_s=[3, 4, 5]", "match.halves=3"], (3, 4, 5)),
    ],
)
def test_the_command_line_sets_them_all_or_their_number(overrides, lengths_s):
    assert half_lengths_s(scenario("match: {halves: 2, half_s: [20, 10]}\n", overrides).match) == lengths_s


@pytest.mark.parametrize(
    ("match", "expected"),
    [
        ("{halves: 2, half_s: [5]}", "wrong-value match.half_s"),
        ("{half_s: [5, 6]}", "wrong-value match.half_s"),
        ("{half_s: [5, 0.01], halves: 2}", "wrong-value match.half_s[1]"),
        ("{half_s: []}", "wrong-value match.half_s"),
        ("{half_s: long}", "wrong-value match.half_s"),
    ],
)
def test_lengths_that_fit_no_half_are_refused(match, expected):
    assert complaints(f"match: {match}\n") == [expected]


@pytest.mark.parametrize(
    "overrides", [["match.half_s=[3, 4, 5]"], ["match.half_s=[3]"], ["match.half_s=[3, 4]", "match.halves=1"]]
)
def test_lengths_of_the_command_line_are_as_many_as_halves(overrides):
    (problem,) = errors("match: {halves: 2, half_s: [20, 10]}\n", overrides)
    assert (problem.code, problem.where) == ("wrong-value", InFile(f"--set {overrides[0]}", path="match.half_s"))


@pytest.mark.parametrize(("key", "own"), [("halves", "{halves: 3}"), ("half_s", "{half_s: [5, 6, 7]}")])
def test_wrong_number_of_lengths_is_reported_in_the_authors_file_not_in_its_base(key, own, tmp_path):
    (tmp_path / "base.yaml").write_text(f"{HEAD}match: {{halves: 2, half_s: [20, 10]}}\n", encoding="utf-8")
    mine = tmp_path / "mine.yaml"
    mine.write_text(f"extends: base.yaml\nid: mine\nmatch: {own}\n", encoding="utf-8")
    with pytest.raises(ScenarioError) as refused:
        load(mine)
    (problem,) = refused.value.diagnostics
    assert (place_of(problem).file, place_of(problem).path) == (str(mine), f"match.{key}")


def test_one_number_is_written_as_before_there_were_lists():
    assert scenario("match: {halves: 2, half_s: 20}\n").dumped()["match"] == {
        "halves": 2, "half_s": 20.0, "called": None, "swap_sides": False,
    }  # fmt: skip
    several = scenario("match: {halves: 2, half_s: [20, 10]}\n")
    assert type(several).model_validate(in_tuples(several.dumped())) == several


TOLD = rule(
    "{trigger: half_ended}",
    "{action: emit, event: OVER, payload: {length_s: {word: total_match_time_s}}}",
    "    says: It is over.\n"
    "expect:\n"
    "  the_first_half: {keyframes: [{at_s: 0}], lasts_s: 4, events: [{event: OVER, at_s: 4, payload: {length_s: 4}}]}\n"
    "  the_second_half: {half: 2, keyframes: [{at_s: 0}], lasts_s: %s, events: [{event: OVER, at_s: 2, payload: {length_s: 2}}]}\n",
)


def test_tests_play_the_half_at_its_length():
    one = loaded("match: {halves: 2, half_s: [4, 2]}\n" + TOLD % 2)
    assert [run_test(one, name).differences for name in one.scenario.expect] == [(), ()]


def test_a_test_is_no_longer_than_its_own_half():
    assert complaints("match: {halves: 2, half_s: [4, 2]}\n" + TOLD % 3) == ["too-late expect.the_second_half.lasts_s"]
