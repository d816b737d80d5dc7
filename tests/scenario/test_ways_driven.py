"""Names, sense and lint of ways: how far things have driven or rolled."""

import pytest

from tests.scenario.writing import complaints, kinds, scenario

WAITS = "{trigger: holds, condition: {condition: way, entity: Y1, at_least: 2}}"


def rule(action="{action: end}", condition="", trigger="{trigger: half_started}", more=""):
    asked = f"conditions: [{condition}], " if condition else ""
    return f"{more}rules:\n  r: {{{asked}triggers: [{trigger}], actions: [{action}]}}\n"


@pytest.mark.parametrize(
    ("written", "complaint"),
    [
        (
            rule(condition="{condition: way, entity: Y1}"),
            "rules.r.conditions[0] (way): nothing to compare with; give at least one of at_least, at_most, equals",
        ),
        (
            rule(condition="{condition: way, entity: centre, at_most: 1}"),
            "rules.r.conditions[0] (way): 'centre' is a spot; expected an entity",
        ),
        (
            rule(condition="{condition: way, entity: yellow, at_most: 1, of: {at_least: 4}}"),
            "rules.r.conditions[0] (way): at least 4 of 3 can never hold",
        ),
        (
            rule("{action: score, entrant: yellow, points: {way: yellow}}"),
            "rules.r.actions[0] (score): 'yellow' is a group; name one entity",
        ),
        (
            rule("{action: score, entrant: yellow, points: {way: each}}"),
            "rules.r.actions[0] (score): 'each' is known only in a rule with for_each",
        ),
    ],
)
def test_what_has_no_way_is_refused(written, complaint):
    (said,) = complaints(written)
    assert said == complaint


def test_a_way_in_the_broadcast_and_a_counter_that_is_a_limit_are_read():
    budget = "counters: {budget: {initial: 2}}\nbroadcast: {fields: {way: {way: Y1}}}\n"
    written = rule(condition="{condition: way, entity: Y1, at_least: {counter: budget}}", more=budget)
    assert "never-read" not in kinds(written)
    assert scenario(written).broadcast.fields["way"].way == "Y1"
