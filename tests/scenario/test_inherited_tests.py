"""Who changes a line of an existing challenge does not have to repair its tests first."""

from __future__ import annotations

import json

import pytest

from rcj_challenges.cli.test import play_tests
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.scenario.load import load

HEAD = "schema_version: 2\nid: mine\ntitle: Mine\n"
BASE = """\
zones: {corner: {shape: rect, x_max_m: -0.5, y_max_m: -0.6}}
rules:
  scored:
    triggers: [{trigger: enters, entity: ball, zone: corner}]
    actions: [{action: score, entrant: yellow, points: 1}]
expect:
  a_ball_in_the_corner_counts:
    keyframes: [{at_s: 0.5, place: {ball: [-0.55, -0.65]}}]
    lasts_s: 1
    score: {yellow: 1}
  a_robot_may_stand_in_the_corner:
    keyframes: [{at_s: 0.5, place: {Y3: [-0.55, -0.65]}}]
    lasts_s: 100
    score: {yellow: 0}
"""
REASON = "a_robot_may_stand_in_the_corner"


@pytest.fixture
def mine(tmp_path):
    """Return what writes a scenario beside its base and returns its path."""
    (tmp_path / "base.yaml").write_text(f"{HEAD}extends: soccersim_v2\n{BASE}", encoding="utf-8")

    def write(text: str) -> str:
        path = tmp_path / "mine.yaml"
        path.write_text(f"{HEAD}extends: base.yaml\n{text}", encoding="utf-8")
        return str(path)

    return write


@pytest.mark.parametrize(
    "change",
    [
        "match: {halves: 1, half_s: 60}\n",
        "robots: {Y3: null}\nentrants: {yellow: {robots: {Y3: null}}}\n",
    ],
)
def test_inherited_tests_that_do_not_fit_are_left_out_and_the_others_stay(mine, change):
    loaded = load(mine(change))
    assert list(loaded.scenario.expect) == ["a_ball_in_the_corner_counts"]
    assert list(loaded.left_out) == [REASON]
    (finding,) = [one for one in lint(loaded) if one.code == "inherited-test-left-out"]
    assert REASON in finding.message
    assert "inherited: null" in finding.help


def test_a_test_that_its_author_has_changed_is_no_inherited_one(mine):
    with pytest.raises(ScenarioError, match="too-late"):
        load(mine(f"match: {{half_s: 60}}\nexpect: {{{REASON}: {{lasts_s: 99}}}}\n"))


OWN = "{keyframes: [{at_s: 0.5}], lasts_s: 1, score: {yellow: 0}}"


@pytest.mark.parametrize("text", ["inherited: null, mine: " + OWN, "mine: " + OWN + ", inherited: null"])
def test_all_inherited_tests_are_removed_at_once_and_own_ones_stay(mine, text):
    loaded = load(mine(f"match: {{half_s: 60}}\nexpect: {{{text}}}\n"))
    assert list(loaded.scenario.expect) == ["mine"]
    assert not loaded.left_out
    assert not [one for one in lint(loaded) if one.code == "inherited-test-left-out"]


def test_left_out_tests_are_listed_when_tests_are_run(mine, capsys):
    path = mine("match: {half_s: 60}\n")
    assert play_tests([path]) == 0
    reported = capsys.readouterr().out
    assert f"left out: {REASON}" in reported
    assert "100 s is longer than a half, 60 s" in reported
    assert play_tests([path], json_=True) == 0
    assert list(json.loads(capsys.readouterr().out)["files"][0]["left_out"]) == [REASON]


def test_a_failing_inherited_test_names_its_origin_and_an_own_one_does_not(mine, capsys):
    stricter = "rules: {scored: {actions: [{action: score, entrant: yellow, points: 2}]}}\n"
    own = "expect: {mine: {keyframes: [{at_s: 0.5}], lasts_s: 1, score: {yellow: 7}}}\n"
    path = mine(stricter + own)
    assert play_tests([path], json_=True) == 1
    tests = {test["name"]: test for test in json.loads(capsys.readouterr().out)["files"][0]["tests"]}
    assert not tests["a_ball_in_the_corner_counts"]["passed"]
    assert tests["a_ball_in_the_corner_counts"]["inherited_from"].endswith("base.yaml")
    assert (tests["mine"]["passed"], tests["mine"]["inherited_from"]) == (False, None)
    assert play_tests([path]) == 1
    reported = capsys.readouterr().out
    assert reported.count("replace it, or remove it by 'a_ball_in_the_corner_counts: null' under expect") == 1
    assert reported.count("inherited from") == 1


def test_two_a_side_from_the_shipped_match_needs_no_more_than_its_own_lines(tmp_path):
    path = tmp_path / "two.yaml"
    path.write_text(
        f"{HEAD}extends: match\nmatch: {{half_s: 180}}\nrobots: {{B3: null, Y3: null}}\n"
        "entrants: {blue: {robots: {B3: null}}, yellow: {robots: {Y3: null}}}\n"
        "placements:\n"
        "  blue_kicks_off: [{entity: [B1, B2, Y1, Y2], at: start}, {entity: ball, at: {point: [0, 0]}}]\n"
        "  yellow_kicks_off: [{entity: [B1, B2, Y1, Y2], at: start}, {entity: ball, at: {point: [0, 0]}}]\n",
        encoding="utf-8",
    )
    loaded = load(path)
    assert list(loaded.scenario.robots) == ["B1", "B2", "Y1", "Y2"]
    assert loaded.left_out
    assert {one.code for one in lint(loaded)} == {"inherited-test-left-out"}
