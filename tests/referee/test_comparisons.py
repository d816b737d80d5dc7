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
    assert holds(stage, f"counter: n, {bounds}") is expected


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        ("flag: a", True),
        ("flag: b", False),
        ("flag: a, equals: {flag: b}", False),
        ("flag: a, equals: {flag: b}, negate: true", True),
        ("flag: out, entity: robots, of: none", True),
    ],
)
def test_a_flag_is_compared_with_another_or_alone(stage, condition, expected):
    flags = "flags: {a: {initial: true}, b: {}, out: {per: robots}}"
    play = stage(SECOND, flags, once(10, EMIT, more=f"conditions: [{{{condition}}}],"))
    play.play(12)
    assert bool(play.events_named("TOLD")) is expected


@pytest.mark.parametrize("bound", ["at_least", "at_most", "above", "below", "equals"])
def test_with_none_no_comparison_holds_and_every_negated_one_does(stage, bound):
    condition = f"counter: n, {bound}: {{distance: [Y1, ball]}}"
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
    assert holds(stage, f"counter: laps, at_least: 2, of: {of}", *counted) is expected


@pytest.mark.parametrize(
    ("condition", "code"),
    [
        ("counter: n, above: 3, at_most: 3", "empty-range"),
        ("counter: n, above: 3, at_least: 3", "conflicting-keys"),
        ("counter: n, equals: 3, below: 4", "conflicting-keys"),
        ("counter: laps, above: 3, of: {at_least: 1, at_most: 2}", "conflicting-keys"),
        ("counter: laps, above: 3, of: {}", "missing-key"),
        ("highest: [{counter: n}, 2], above: 3, of: all", "not-per-entity"),
        ("entity: Y1", "missing-key"),
        ("entity: ball, held: true", "wrong-kind"),
    ],
)
def test_what_can_never_hold_is_refused(condition, code):
    head = "schema_version: 2\nid: it\ntitle: It\nextends: soccersim_v2\n"
    rule = f"{{triggers: [{{trigger: half_started}}], conditions: [{{{condition}}}], actions: [{{action: end}}]}}"
    with pytest.raises(ScenarioError) as caught:
        load_text(f"{head}{COUNTERS}rules: {{r: {rule}}}")
    assert {one.code for one in caught.value.diagnostics} == {code}


@pytest.mark.parametrize(
    ("condition", "expected"),
    [
        ("score: blue, minus: {score: yellow}, at_least: 2", True),
        ("score: blue, minus: {score: yellow}, above: 2", False),
        ("count: yellow, in: right, equals: 1", True),
        ("count: robots, above: 3", True),
        ("sum: {counter: laps}, equals: 4", True),
        ("highest: {counter: laps, entity: yellow}, below: 2", True),
        ("word: time_s, below: 0.33", True),
        ("told: Y1, at_least: 0, negate: true", True),
        ("distance: [yellow, ball], at_most: 0.65, of: all", True),
        ("entity: yellow, in: right", True),
        ("entity: yellow, in: right, of: all", False),
        ("entity: Y2, in: right, looks: 1.57", True),
        ("entity: Y2, in: right, held: true", False),
        ("any_of: [{counter: n, equals: 0}, [{counter: n, equals: 3}, {counter: m, equals: 2}]]", True),
        ("any_of: [{counter: n, equals: 0}, [{counter: n, equals: 3}, {counter: m, equals: 3}]]", False),
    ],
)
def test_any_value_with_a_comparison_is_a_condition(stage, condition, expected):
    assert holds(stage, condition, "{action: score, entrant: blue, points: 2}") is expected


def test_a_fact_is_true_of_what_touches_and_for_a_moment_after(stage):
    rule = once(10, EMIT, name="asked", more="conditions: [{entity: Y1, touching: [ball, walls]}],")
    for at, expected in ((2, False), (8, True)):
        play = stage(SECOND, rule)
        play.play(at)
        play.touch("Y1", "ball")
        play.play(12 - at)
        assert bool(play.events_named("TOLD")) is expected


def test_all_conditions_of_holds_must_hold(stage):
    rule = "{trigger: holds, conditions: [{entity: ball, in: right}, {entity: Y1, in: right}], for_s: 0.1}"
    play = stage(SECOND, f"rules: {{told: {{triggers: [{rule}], actions: [{EMIT}]}}}}")
    play.play(3)
    play.place("ball", 0.4, 0)
    play.play(10)
    assert not play.events_named("TOLD")
    play.place("Y1", 0.3, 0)
    play.play(10)
    assert [event.tick for event in play.events_named("TOLD")] == [18]
