"""Lint of goals that are taken away while rules wait for what comes into them."""

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load_text
from tests.scenario.writing import HEAD

GONE = "field: {goals: {blue_goal: null, yellow_goal: null}}\n"
ENTERS = "triggers: [{trigger: enters, entity: ball, zone: %s}]"
RULE = "rules:\n  goal: {%s, actions: [{action: score, entrant: yellow}], says: A goal.}\n"


def found(body):
    return [one for one in lint(load_text(HEAD + body, file="a.yaml")) if one.kind == "goal_is_gone"]


def test_a_rule_that_waits_for_the_ball_in_a_goal_behind_a_closed_wall():
    (one,) = found(GONE + RULE % (ENTERS % "blue_goal"))
    assert one.problem.path == "field.goals"
    assert one.problem.message == (
        "goal 'blue_goal' is taken away and the wall closed there, and its zone is still waited for, where nothing "
        "comes in, by goal"
    )
    assert "take the zone away too (zones: {blue_goal: null})" in one.remedy


@pytest.mark.parametrize(
    ("what", "count"),
    [
        (ENTERS % "[blue_goal, yellow_goal]", 2),
        (ENTERS % "[blue_goal, pitch]", 0),
        (ENTERS % "pitch", 0),
        ("triggers: [{trigger: leaves, entity: ball, zone: in_play}]", 0),
        ("triggers: [{trigger: stays_in, entity: ball, zone: blue_goal, limit_s: 2}]", 1),
        (ENTERS % "pitch" + ", conditions: [{condition: in_zone, entity: ball, zone: blue_goal}]", 1),
        (ENTERS % "pitch" + ", conditions: [{condition: in_zone, entity: ball, zone: blue_goal, negate: true}]", 0),
    ],
)
def test_only_what_must_come_into_it_counts(what, count):
    assert len(found(GONE + RULE % what)) == count


@pytest.mark.parametrize(
    "body",
    [
        "",
        "field: {goals: {yellow_goal: null}}\n",
        GONE + "zones: {blue_goal: {y_min_m: 0.5, y_max_m: 0.75}}\n",
        GONE + "zones: {blue_goal: {shape: circle, centre_m: [0, 0], radius_m: 0.1}}\n",
        "field: {length_m: 2, goals: {blue_goal: null}}\n",  # the wall is further away, and the zone on the field
    ],
)
def test_where_the_goal_is_there_or_its_zone_is_elsewhere_nothing_is_said(body):
    assert found(body + RULE % (ENTERS % "blue_goal")) == []


def test_a_step_of_a_sequence_waits_too():
    way = "sequences: {way: {entity: ball, steps: [pitch, blue_goal]}}\n"
    done = RULE % "triggers: [{trigger: sequence_completed, sequence: way}]"
    (one,) = found(GONE + way + done)
    assert one.problem.message.endswith("by way")
    other = way.replace("blue_goal]", "{any_of: [blue_goal, pitch]}]")
    assert found(GONE + other + done) == []
