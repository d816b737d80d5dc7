"""Lint of speeds that nothing has."""

import pytest

from rcj_challenges.scenario.lint.table import lint
from rcj_challenges.scenario.load import load_text
from tests.scenario.writing import HEAD


def found(condition):
    body = f"rules: {{r: {{triggers: [{{trigger: time_reached, at_s: 5}}], conditions: [{condition}], actions: [{{action: end}}]}}}}\n"
    return [str(one) for one in lint(load_text(HEAD + body, file="a.yaml")) if one.kind == "speed_never_reached"]


def test_a_robot_in_centimetres_per_second():
    (text,) = found("{condition: speed, entity: Y1, at_least: 15}")
    assert text.partition("warning: ")[2] == (
        "rules.r.conditions[0] (speed): it is never reached: a robot drives 0.2 m/s at most; correct it; speeds are in m/s "
        "[speed_never_reached]"
    )


@pytest.mark.parametrize(
    ("condition", "count"),
    [
        ("{condition: speed, entity: Y1, at_least: 0.3}", 0),
        ("{condition: speed, entity: Y1, at_most: 15}", 0),
        ("{condition: speed, entity: Y1, at_least: {counter: yellow}}", 0),
        ("{condition: speed, entity: ball, at_least: 3}", 0),
        ("{condition: speed, entity: ball, at_least: 50}", 1),
        ("{condition: any_of, conditions: [{condition: speed, entity: yellow, at_least: 10}]}", 1),
    ],
)
def test_what_may_be_reached_is_not_told(condition, count):
    assert len(found(condition)) == count


@pytest.mark.parametrize(
    ("asked", "count"),
    [
        ("entity: Y1, distance_m: 50, within_s: 15", 1),
        ("entity: Y1, distance_m: 3.1, within_s: 15", 1),
        ("entity: Y1, distance_m: 0.5, within_s: 15", 0),
        ("entity: ball, distance_m: 50, within_s: 15", 1),
        ("entity: ball, distance_m: 40, within_s: 15", 0),
        ("entity: obstacles, distance_m: 0.1, within_s: 15", 0),  # there are none, and for nobody it fires
    ],
)
def test_nobody_makes_more_progress_than_its_speed_allows(asked, count):
    body = f"rules: {{r: {{triggers: [{{trigger: no_progress, {asked}}}], actions: [{{action: end}}]}}}}\n"
    found = [str(one) for one in lint(load_text(HEAD + body, file="a.yaml")) if one.kind == "speed_never_reached"]
    assert len(found) == count
    assert all("so that it fires whatever they do" in text and "distances are in m" in text for text in found)
