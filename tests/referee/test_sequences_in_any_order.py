"""Sequences whose steps may be made in any order: complete when all are made, as in biathlon or a treasure hunt."""

import pytest

from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.sheet import sheet_markdown
from tests.referee.building import walk
from tests.views.sheets import section

HEAD = "schema_version: 2\nid: x\ntitle: X\nextends: soccersim_v2\n"
A, B, C, OUT = (-0.4, 0), (0, 0.4), (0.4, 0), (0, -0.5)  # no way between two of them leads over the third
TARGETS = """
zones:
  a: {shape: circle, centre_m: [-0.4, 0], radius_m: 0.1}
  b: {shape: circle, centre_m: [0, 0.4], radius_m: 0.1}
  c: {shape: circle, centre_m: [0.4, 0], radius_m: 0.1}
sequences: {targets: {entity: Y1, order: any, steps: [a, b, c]%s}}
rules:
  done: {triggers: [{trigger: sequence_completed, sequence: targets}], actions: [{action: score, entrant: yellow}]}
"""


def points(stage, *places, more=""):
    play = stage(TARGETS % more)
    walk(play, "Y1", *places)
    return play.referee.scores["yellow"]


@pytest.mark.parametrize("places", [(A, B, C), (A, C, B), (B, A, C), (B, C, A), (C, A, B), (C, B, A)])
def test_each_order_is_right(stage, places):
    assert points(stage, *places) == 1


@pytest.mark.parametrize(
    ("places", "expected"),
    [((A, B), 0), ((A, B, A, B), 0), ((C, C, A, C, B), 1), ((A, C, B, OUT, B, C, A), 2), ((A, C, B, C, A), 1)],
)
def test_it_is_complete_when_all_steps_are_made_and_then_starts_again(stage, places, expected):
    assert points(stage, *places) == expected


@pytest.mark.parametrize(
    ("places", "expected"), [((B, A, C), 0), ((B, A, C, A), 0), ((B, A, C, B), 1), ((B, A, C, B, C, A, B), 2)]
)
def test_a_cyclic_one_also_needs_the_way_back_to_the_step_that_was_made_first(stage, places, expected):
    assert points(stage, *places, more=", cyclic: true") == expected


def test_a_robot_that_stands_on_a_step_has_made_it(stage):
    """As with the first step of a listed one; a placement forgets the others."""
    place = "rules: {put: {triggers: [{trigger: time_reached, at_s: 0.32}], actions: [{action: place, entity: Y1, at: {point: [0, 0.4]}}]}}"
    play = stage(TARGETS % "", place)
    walk(play, "Y1", A)
    play.play_until(12)
    walk(play, "Y1", C)
    assert play.referee.scores["yellow"] == 0
    walk(play, "Y1", A)
    assert play.referee.scores["yellow"] == 1


def test_no_step_is_wrong_so_none_can_break_it():
    with pytest.raises(ScenarioError) as refused:
        load_text(HEAD + TARGETS % ", wrong_step: break")
    assert [problem.code for problem in refused.value.diagnostics] == ["conflicting-keys"]


def test_the_sheet_says_that_any_order_is_right():
    loaded = load_text(HEAD + TARGETS % ", cyclic: true")
    course = section(sheet_markdown(loaded.scenario, loaded.roster).replace("\\", ""), "Course")
    assert "of Y1: the zone “a”, the zone “b” and the zone “c”, in any order, and back to the first. It" in course
    assert "out of turn" not in course
