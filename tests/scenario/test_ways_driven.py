"""Names, sense and lint of ways: how far things have driven or rolled."""

import pytest

from tests.scenario.writing import complaints, kinds, scenario

WAITS = "{trigger: holds, condition: {condition: way, entity: Y1, at_least: 2}}"


def rule(action="{action: end}", condition="", trigger="{trigger: half_started}", more=""):
    asked = f"conditions: [{condition}], " if condition else ""
    return f"{more}rules:\n  r: {{{asked}triggers: [{trigger}], actions: [{action}]}}\n"


@pytest.mark.parametrize(
    ("written", "expected"),
    [
        (rule(condition="{condition: way, entity: Y1}"), "missing-key rules.r.conditions[0] (way)"),
        (rule(condition="{condition: way, entity: centre, at_most: 1}"), "wrong-kind rules.r.conditions[0] (way)"),
        (
            rule(condition="{condition: way, entity: yellow, at_most: 1, of: {at_least: 4}}"),
            "never-holds rules.r.conditions[0] (way)",
        ),
        (rule("{action: score, entrant: yellow, points: {way: yellow}}"), "wrong-kind rules.r.actions[0] (score)"),
        (rule("{action: score, entrant: yellow, points: {way: each}}"), "unbound-name rules.r.actions[0] (score)"),
    ],
)
def test_what_has_no_way_is_refused(written, expected):
    assert complaints(written) == [expected]


def test_a_way_in_the_broadcast_and_a_counter_that_is_a_limit_are_read():
    budget = "counters: {budget: {initial: 2}}\nbroadcast: {fields: {way: {way: Y1}}}\n"
    written = rule(condition="{condition: way, entity: Y1, at_least: {counter: budget}}", more=budget)
    assert "never-read" not in kinds(written)
    assert scenario(written).broadcast.fields["way"].way == "Y1"
