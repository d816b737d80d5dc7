"""Comparisons with two numbers and with values, and of how many of a group they must be true."""

import pytest

from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.load import load_text
from tests.referee.building import EMIT, once

SECOND = "schema_version: 2\n"
COUNTERS = "counters: {n: {initial: 3}, m: {initial: 2}, laps: {per: robots, initial: 1}}\n"


def holds(stage, condition: str, *before: str) -> bool:
    """Return whether a condition holds at tick 10, after actions at the start."""
    start = f"rules: {{start: {{triggers: [{{trigger: half_started}}], actions: [{', '.join(before)}]}}}}"
    asked = once(10, EMIT, name="asked", more=f"conditions: [{{{condition}}}],")
    play = stage(SECOND, COUNTERS, *([start] if before else []), asked)
    play.play(12)
    return bool(play.events_named("TOLD"))


@pytest.mark.parametrize(
    ("bounds", "expected"),
    [
        ("above: 3", False),
        ("above: 2.9", True),
        ("below: 3", False),
        ("below: 3.1", True),
        ("above: 2, below: 4", True),
        ("at_least: 3, below: 4", True),
        ("above: 3, at_most: 4", False),
        ("above: 2, negate: true", False),
        ("above: {counter: m}", True),
        ("below: {counter: m, plus: 1}", False),
        ("equals: {counter: m, times: 1.5}", True),
    ],
)
def test_a_number_is_compared_with_numbers(stage, bounds, expected):
    assert holds(stage, f"condition: counter, counter: n, {bounds}") is expected


@pytest.mark.parametrize("bound", ["at_least", "at_most", "above", "below", "equals"])
def test_with_none_no_comparison_holds_and_every_negated_one_does(stage, bound):
    condition = f"condition: counter, counter: n, {bound}: {{distance: [Y1, ball]}}"
    off = "{action: remove, entity: ball}"
    assert not holds(stage, condition, off)
    assert holds(stage, f"{condition}, negate: true", off)


@pytest.mark.parametrize(
    ("of", "expected"),
    [
        ("{at_least: 2}", True),
        ("{at_least: 3}", False),
        ("{at_most: 2}", True),
        ("{at_most: 1}", False),
        ("{equals: 2}", True),
        ("{equals: 3}", False),
        ("{equals: 0}", False),
    ],
)
def test_of_how_many_of_a_group_it_must_be_true(stage, of, expected):
    counted = (f"{{action: count, counter: laps, entity: {robot}}}" for robot in ("Y1", "B1"))
    assert holds(stage, f"condition: counter, counter: laps, at_least: 2, of: {of}", *counted) is expected


@pytest.mark.parametrize(
    ("condition", "code"),
    [
        ("counter: n, above: 3, at_most: 3", "empty-range"),
        ("counter: n, above: 3, at_least: 3", "conflicting-keys"),
        ("counter: n, equals: 3, below: 4", "conflicting-keys"),
        ("counter: laps, above: 3, of: {at_least: 1, at_most: 2}", "conflicting-keys"),
        ("counter: laps, above: 3, of: {}", "missing-key"),
    ],
)
def test_what_can_never_hold_is_refused(condition, code):
    head = "schema_version: 2\nid: it\ntitle: It\nextends: soccersim_v2\n"
    rule = f"{{triggers: [{{trigger: half_started}}], conditions: [{{condition: counter, {condition}}}], actions: [{{action: end}}]}}"
    with pytest.raises(ScenarioError) as caught:
        load_text(f"{head}{COUNTERS}rules: {{r: {rule}}}")
    assert {one.code for one in caught.value.diagnostics} == {code}
