"""Names, errors and lint of spots that rules set."""

import pytest

from tests.scenario.writing import complaints, kinds, scenario

SPOTS = "spots: {found: {x_m: 0, y_m: 0.2}, other_one: {x_m: 0.5, y_m: -0.5}}\ngroups: {both: [found, other_one]}\n"
PLACES = (
    "gates: {line: {from_m: [0, 0], to_m: [0.1, 0]}}\nzones:\n"
    "  tri: {shape: polygon, points_m: [[0, 0], [0.1, 0], [0, 0.1]]}\n"
    "  around: {shape: circle, centre_m: [0, 0], radius_m: 0.2, inverted: true}\n"
)
SET = "{action: set_spot, spot: found, to: ball}"


def rules(*actions, conditions="", more=""):
    asked = f"conditions: [{conditions}], " if conditions else ""
    return f"{SPOTS}{PLACES}{more}rules:\n  r: {{{asked}triggers: [{{trigger: half_started}}], actions: [{', '.join(actions)}]}}\n"


@pytest.mark.parametrize(
    ("action", "expected"),
    [
        ("{action: set_spot, spot: centr, to: ball}", "unknown-name rules.r.actions[0] (set_spot) -> centre"),
        ("{action: set_spot, spot: ball, to: Y1}", "wrong-kind rules.r.actions[0] (set_spot)"),
        ("{action: set_spot, spot: found, to: line}", "wrong-kind rules.r.actions[0] (set_spot)"),
        ("{action: set_spot, spot: found, to: blue_penalty_area}", "no-centre rules.r.actions[0] (set_spot)"),
        ("{action: set_spot, spot: found, to: tri}", "no-centre rules.r.actions[0] (set_spot)"),
        ("{action: set_spot, spot: found, to: around}", "no-centre rules.r.actions[0] (set_spot)"),
        ("{action: set_spot, spot: found, to: each}", "unbound-name rules.r.actions[0] (set_spot)"),
        ("{action: set_spot, spot: both, to: ball}", "wrong-kind rules.r.actions[0] (set_spot)"),
        ("{action: set_spot, spot: found}", "missing-key rules.r.actions[0] (set_spot)"),
    ],
)
def test_what_a_rule_cannot_set_is_refused(action, expected):
    assert complaints(rules(action)) == [expected]


def test_a_test_can_ask_where_a_spot_is_at_the_end():
    test = "expect: {it: {keyframes: [{at_s: 0}], lasts_s: 1, poses: {%s: [0, 0]}}}\n"
    assert scenario(rules(SET) + test % "found").expect["it"].poses == {"found": (0.0, 0.0)}
    assert complaints(rules(SET) + test % "blue_goal") == ["wrong-kind expect.it.poses.blue_goal"]


def test_a_test_that_asks_for_it_is_no_use_of_it():
    test = "expect: {it: {keyframes: [{at_s: 0}], lasts_s: 1, poses: {found: [0, 0]}}}\n"
    assert "never-read" in kinds(rules(SET) + test)


def test_a_spot_that_no_rule_sets_need_not_be_read():
    assert kinds(rules("{action: end}")) & {"never-read"} == set()
