"""Lint of conditions that a trigger denies, also within any_of and all_of, and of sequences whose steps decide nothing."""

import pytest

from rcj_challenges.scenario.lint.logic import are_apart
from rcj_challenges.scenario.models.places import CircleZone, HalfPlaneZone, PolygonZone, RectZone
from tests.scenario.writing import findings, rule

IN = "{condition: in_zone, entity: ball, zone: blue_goal}"
OUT = "{condition: in_zone, entity: ball, zone: blue_goal, negate: true}"
Y1_OUT = OUT.replace("ball", "Y1")


def never_fires(condition):
    enters = "triggers: [{trigger: enters, entity: ball, zone: blue_goal}], actions: [{action: end}]"
    text = f"rules: {{r: {{{enters}, conditions: [{condition}]}}}}\n"
    return any("rule_never_fires" in one for one in findings(text))


@pytest.mark.parametrize(
    ("condition", "denied"),
    [
        (OUT, True),
        # Who has just come into one goal is not in the other one.
        ("{condition: in_zone, entity: ball, zone: yellow_goal}", True),
        ("{condition: in_zone, entity: ball, zone: [yellow_goal, pitch]}", False),
        ("{condition: in_zone, entity: Y1, zone: yellow_goal}", False),
        (f"{{condition: any_of, conditions: [{OUT}]}}", True),
        (f"{{condition: any_of, conditions: [{OUT}, {OUT}]}}", True),
        (f"{{condition: any_of, conditions: [{OUT}, {Y1_OUT}]}}", False),
        (f"{{condition: any_of, conditions: [{IN}]}}", False),
        (f"{{condition: any_of, negate: true, conditions: [{IN}, {Y1_OUT}]}}", True),
        (f"{{condition: any_of, negate: true, conditions: [{OUT}]}}", False),
        (f"{{condition: all_of, conditions: [{OUT}, {Y1_OUT}]}}", True),
        (f"{{condition: all_of, conditions: [{IN}, {Y1_OUT}]}}", False),
        (f"{{condition: all_of, negate: true, conditions: [{IN}, {IN}]}}", True),
        (f"{{condition: all_of, negate: true, conditions: [{IN}, {Y1_OUT}]}}", False),
        (f"{{condition: any_of, conditions: [{OUT}, {{condition: all_of, conditions: [{OUT}, {IN}]}}]}}", True),
    ],
)
def test_a_rule_whose_trigger_denies_all_of_several_conditions_never_fires(condition, denied):
    assert never_fires(condition) is denied


@pytest.mark.parametrize(
    ("one", "other", "denied"),
    [
        (IN, OUT, True),
        (IN, "{condition: in_zone, entity: ball, zone: yellow_goal}", True),
        (IN, "{condition: in_zone, entity: Y1, zone: yellow_goal}", False),
        (
            "{condition: counter, counter: yellow, at_least: 3}",
            "{condition: counter, counter: yellow, at_most: 2}",
            True,
        ),
        (
            "{condition: counter, counter: yellow, at_least: 3}",
            "{condition: counter, counter: blue, at_most: 2}",
            False,
        ),
        (IN, f"{{condition: any_of, conditions: [{OUT}, {Y1_OUT}]}}", False),
    ],
)
def test_a_rule_of_which_two_conditions_never_hold_together_never_fires(one, other, denied):
    body = (
        f"rules: {{r: {{triggers: [{{trigger: time_reached, at_s: 5}}], conditions: [{one}, {other}], "
        "actions: [{action: end}]}}\n"
    )
    found = [text for text in findings(body) if "rule_never_fires" in text]
    said = (
        "conditions: all of them must hold, and two of them never do at the same time; take one of them out, or write "
        "those of which one suffices as {condition: any_of, conditions: […]} [rule_never_fires]"
    )
    assert [text.partition("rules.r.")[2] for text in found] == [said] * denied


@pytest.mark.parametrize("lasting", [False, True])
def test_of_more_than_two_conditions_those_are_named_that_never_hold_together(lasting):
    near, far = (f"{{condition: distance, entity: ball, to: Y1, {one}}}" for one in ("at_least: 0.3", "at_most: 0.1"))
    three = f"[{near}, {IN}, {far}]"
    trigger, conditions = "{trigger: time_reached, at_s: 5}", three
    if lasting:
        trigger, conditions = (
            f"{{trigger: holds, condition: {{condition: all_of, conditions: {three}}}, for_s: 1}}",
            "[]",
        )
    body = f"rules: {{r: {{triggers: [{trigger}], conditions: {conditions}, actions: [{{action: end}}]}}}}\n"
    (text,) = [one for one in findings(body) if "rule_never_fires" in one]
    assert f"two of them never do at the same time: {near} and {far}; take one of them out" in text


def test_of_a_sequence_that_rules_only_begin_anew_the_steps_decide_nothing():
    way = "sequences: {way: {entity: ball, steps: [blue_goal, yellow_goal]}}\n"
    (text,) = [one for one in findings(way + rule(action="{action: sequence, sequence: way}")) if "sequence" in one]
    assert "sequence 'way' only begins anew: its steps decide nothing; " in text
    (unnamed,) = [one for one in findings(way + rule()) if "sequence" in one]
    assert "sequence 'way' is never used; name it in a rule, or remove it" in unnamed


ZONES = (
    "zones: {west: {shape: rect, x_min_m: -0.3, x_max_m: 0, y_min_m: 0, y_max_m: 0.2}, "
    "east: {shape: rect, x_min_m: 0, x_max_m: 0.3, y_min_m: 0, y_max_m: 0.2}}\n"
)


@pytest.mark.parametrize(
    ("trigger", "conditions", "count"),
    [
        (f"holds, condition: {IN}, for_s: 1", OUT, 1),
        (f"holds, condition: {IN}", "{condition: in_zone, entity: ball, zone: yellow_goal}", 1),
        (f"holds, condition: {{condition: all_of, conditions: [{IN}, {OUT}]}}, for_s: 1", "", 1),
        (f"holds, condition: {{condition: any_of, conditions: [{IN}, {OUT}]}}, for_s: 1", "", 0),
        (f"holds, condition: {IN}, for_s: 1, grace_s: 0.5", OUT, 0),
        (f"holds, condition: {IN}, for_s: 1", Y1_OUT, 0),
        (f"holds, condition: {IN}, for_s: 1", "", 0),
        ("stays_in, entity: ball, zone: blue_goal, limit_s: 1", OUT, 1),
        ("stays_in, entity: ball, zone: blue_goal, limit_s: 1", IN, 0),
        ("stays_in, entity: ball, zone: blue_goal, limit_s: 1, grace_s: 0.5", OUT, 0),
    ],
)
def test_what_holds_or_stays_is_true_when_the_rule_fires(trigger, conditions, count):
    text = f"rules: {{r: {{triggers: [{{trigger: {trigger}}}], conditions: [{conditions}], actions: [{{action: end}}]}}}}\n"
    assert sum("rule_never_fires" in one for one in findings(text)) == count


@pytest.mark.parametrize(
    ("second", "count"), [("each, zone: east", 1), ("each, zone: pitch", 0), ("robots, zone: east", 0)]
)
def test_each_is_one_that_is_not_in_two_places(second, count):
    both = f"[{{condition: in_zone, entity: each, zone: west}}, {{condition: in_zone, entity: {second}}}]"
    rule_ = f"{{for_each: robots, triggers: [{{trigger: half_ended}}], conditions: {both}, actions: [{{action: end}}]}}"
    assert sum("rule_never_fires" in one for one in findings(f"{ZONES}rules: {{r: {rule_}}}\n")) == count


LEFT, RIGHT = (-0.4, -0.1), (0.1, 0.4)


def circle(x_m: float, radius_m: float, *, inverted: bool = False) -> CircleZone:
    return CircleZone(shape="circle", centre_m=(x_m, 0.0), radius_m=radius_m, inverted=inverted)


def polygon(low: float, high: float) -> PolygonZone:
    return PolygonZone(shape="polygon", points_m=((low, 0.0), (high, 0.0), (high, 0.3)))


def rect(low: float | None, high: float | None) -> RectZone:
    return RectZone(shape="rect", x_min_m=low, x_max_m=high)


@pytest.mark.parametrize(
    ("zone", "other", "apart"),
    [
        (circle(-0.3, 0.2), circle(0.3, 0.2), True),
        (circle(-0.3, 0.2), circle(0.05, 0.2), False),
        (circle(-0.3, 0.2), circle(0.3, 0.2, inverted=True), False),
        (polygon(*LEFT), polygon(*RIGHT), True),
        (polygon(*LEFT), circle(0.0, 0.15), False),
        (rect(None, -0.1), polygon(*RIGHT), True),
        (rect(None, 0.2), polygon(*RIGHT), False),
        (rect(*LEFT), rect(-0.1, None), True),  # who is on their common side is in neither
        (circle(0.3, 0.1), HalfPlaneZone(shape="half_plane", through_m=(0.0, 0.0), normal=(-1.0, 0.0)), False),
    ],
)
def test_zones_are_apart_where_the_rectangles_around_them_are(zone, other, apart):
    assert are_apart(zone, other) is are_apart(other, zone) is apart
