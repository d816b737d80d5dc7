"""Names, errors and lint of spots that rules set."""

import pytest

from rcj_challenges.scenario.lint.registry import lint
from tests.scenario.writing import complaints, kinds, loaded, scenario

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


def found(body):
    return [str(one).partition(" [")[0].split("warning: ")[1] for one in lint(loaded(body))]


@pytest.mark.parametrize(
    ("action", "complaint"),
    [
        (
            "{action: set_spot, spot: centr, to: ball}",
            "rules.r.actions[0] (set_spot): unknown spot 'centr'; did you mean 'centre'?",
        ),
        (
            "{action: set_spot, spot: ball, to: Y1}",
            "rules.r.actions[0] (set_spot): 'ball' is a ball; expected a spot",
        ),
        (
            "{action: set_spot, spot: found, to: line}",
            "rules.r.actions[0] (set_spot): 'line' is a gate; expected an entity, obstacle, spot or zone",
        ),
        (
            "{action: set_spot, spot: found, to: blue_penalty_area}",
            (
                "rules.r.actions[0] (set_spot): zone 'blue_penalty_area' has no end in some direction, and so no centre; set "
                "the spot to an entity, a spot or [x, y]"
            ),
        ),
        (
            "{action: set_spot, spot: found, to: tri}",
            (
                "rules.r.actions[0] (set_spot): zone 'tri' is a polygon, which has no one centre; set the spot to an entity, "
                "a spot or [x, y]"
            ),
        ),
        (
            "{action: set_spot, spot: found, to: around}",
            (
                "rules.r.actions[0] (set_spot): zone 'around' is everything but its shape, which has no centre; set the spot "
                "to an entity, a spot or [x, y]"
            ),
        ),
        (
            "{action: set_spot, spot: found, to: each}",
            "rules.r.actions[0] (set_spot): 'each' is known only in a rule with for_each",
        ),
        (
            "{action: set_spot, spot: both, to: ball}",
            "rules.r.actions[0] (set_spot): 'both' is a group; name one spot",
        ),
        (
            "{action: set_spot, spot: found}",
            (
                "rules.r.actions[0] (set_spot): 'to' is missing: an entity, each, a spot, a zone with a "
                "centre (a circle, a rect with four sides), a draw's name, [x, y] in m, {told: NAME}: the position that a "
                "robot has told by radio, {uniform_in: ZONES} or {on_line: [[x, y], [x, y]]}, a point of chance"
            ),
        ),
    ],
)
def test_what_a_rule_cannot_set_is_refused(action, complaint):
    assert complaints(rules(action)) == [complaint]


def test_a_test_can_ask_where_a_spot_is_at_the_end():
    test = "expect: {it: {keyframes: [{at_s: 0}], lasts_s: 1, poses: {%s: [0, 0]}}}\n"
    assert scenario(rules(SET) + test % "found").expect["it"].poses == {"found": (0.0, 0.0)}
    (complaint,) = complaints(rules(SET) + test % "blue_goal")
    assert complaint.endswith("'blue_goal' is a zone; expected an entity or spot")


def test_a_test_decides_a_place_on_a_line_of_one_point():
    line = "{action: set_spot, spot: found, to: {on_line: [[0.1, 0], [0.1, 0]]}}"
    test = "expect: {it: {keyframes: [{at_s: 0}], lasts_s: 1, spots: {found: %s}}}\n"
    assert scenario(rules(line) + test % "[0.1, 0]").expect["it"].spots == {"found": (0.1, 0.0)}
    (complaint,) = complaints(rules(line) + test % "[0.2, 0]")
    assert "found" in complaint


def test_a_test_that_asks_for_it_is_no_use_of_it():
    test = "expect: {it: {keyframes: [{at_s: 0}], lasts_s: 1, poses: {found: [0, 0]}}}\n"
    assert "never-read" in kinds(rules(SET) + test)


def test_a_spot_that_no_rule_sets_need_not_be_read():
    assert kinds(rules("{action: end}")) & {"never-read"} == set()
