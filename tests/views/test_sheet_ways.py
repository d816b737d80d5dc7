"""What rule sheets say of how far things have driven or rolled."""

import pytest

from tests.views.sheets import sentence
from tests.views.test_sheet_measured import said


@pytest.mark.parametrize(
    ("condition", "words"),
    [
        ("entity: Y1, at_least: 20", "Y1 has a way in this half of at least 20 m"),
        ("entity: ball, at_least: 1, at_most: 2", "the ball has a way in this half of at least 1 m and at most 2 m"),
        ("entity: Y1, at_least: 20, negate: true", "Y1 has a way in this half of less than 20 m"),
        ("entity: Y1, at_most: 20, negate: true", "Y1 has a way in this half of more than 20 m"),
        ("entity: yellow, of: all, at_most: 3", "all of the yellow robots have a way in this half of at most 3 m"),
        ("entity: yellow, of: none, at_least: 3", "none of the yellow robots has a way in this half of at least 3 m"),
    ],
)
def test_a_condition_says_how_far(condition, words):
    assert said(f"{{condition: way, {condition}}}") == words


@pytest.mark.parametrize(
    ("condition", "words"),
    [
        ("at_least: {counter: budget}", "has a way in this half of at least as many m as the counter “budget” says"),
        (
            "negate: true, at_least: {counter: budget}",
            "has a shorter way in this half than the counter “budget” says in m",
        ),
    ],
)
def test_a_counter_can_be_the_limit(condition, words):
    rule = (
        f"triggers: [{{trigger: half_started}}], conditions: [{{condition: way, entity: Y1, {condition}}}], "
        "actions: [{action: end}]"
    )
    assert f"provided that Y1 {words}:" in sentence(rule, "counters: {budget: {}}")


@pytest.mark.parametrize(
    ("action", "words"),
    [
        ("{action: score, entrant: yellow, points: {way: Y1}}", "yellow gets points: the way of Y1 in this half in m"),
        (
            "{action: score, entrant: yellow, points: [10, {way: ball, weight: -2}]}",
            "yellow gets points: 10, minus 2 times the way of the ball in this half in m",
        ),
        (
            "{action: count, counter: driven, to: {way: Y1}}",
            "the counter “driven” is set to the way of Y1 in this half in m",
        ),
        (
            "{action: emit, event: FAR, payload: {far: {way: ball}}}",
            "FAR is announced (far: the way of the ball in this half in m)",
        ),
    ],
)
def test_a_value_says_whose_way(action, words):
    rule = f"triggers: [{{trigger: half_started}}], actions: [{action}]"
    assert sentence(rule, "counters: {driven: {}}").startswith(f"When a half starts: {words}")


def test_of_each_it_is_its_way():
    rule = (
        "for_each: yellow, triggers: [{trigger: holds, condition: {condition: way, entity: each, at_least: 2}}], "
        "actions: [{action: emit, event: FAR, payload: {far: {way: each}}}]"
    )
    words = sentence(rule)
    assert "it has a way in this half of at least 2 m" in words
    assert "far: its way in this half in m" in words
