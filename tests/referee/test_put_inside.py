"""A test that fails says which rules wait for an entry where a rule has put the thing: that is none."""

import pytest

from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.load import Loaded
from rcj_challenges.scenario.roster import Roster

PUT = "put: {triggers: [{trigger: time_reached, at_s: 0.32}], actions: [{action: place, entity: %s, at: {point: [-0.4, 0]}}]}"
MISSING = "missing: THERE, event 1 of the test"
NOTE = (
    "note: a rule put %s into left at 0.32 s, which there does not hear: what is put there has not entered it; "
    "'holds' with in_zone and for_s: 0.05 would"
)


@pytest.fixture
def differences(small):
    def run(
        trigger: str,
        *,
        put: str = "Y1",
        keyframes: str = "[{at_s: 0.1}]",
        more: str = "",
        expected: str = "events: [{event: THERE}]",
    ):
        there = f"there: {{{more} triggers: [{trigger}], actions: [{{action: emit, event: THERE}}]}}"
        rules = f"rules:\n  {there}\n  {PUT % put}\n"
        test = f"expect: {{it: {{lasts_s: 1, keyframes: {keyframes}, {expected}}}}}"
        scenario = small(rules, test)
        return list(run_test(Loaded(scenario, Roster.of(scenario), "test", None, {}), "it").differences)

    return run


OUTSIDE = "[{at_s: 0.1, place: {Y1: [0.4, 0], Y2: [0.4, 0.3], B1: [0.5, -0.3], B2: [0.5, 0.5]}}]"


@pytest.mark.parametrize(
    ("trigger", "more"),
    [
        ("{trigger: enters, entity: Y1, zone: left}", ""),
        ("{trigger: enters, entity: robots, zone: left}", ""),
        ("{trigger: enters, entity: each, zone: left}", "for_each: yellow,"),
    ],
)
def test_what_a_rule_has_put_there_has_not_entered(differences, trigger, more):
    assert differences(trigger, more=more, keyframes=OUTSIDE) == [MISSING, NOTE % "Y1"]


def test_others_elsewhere_and_taken_off_are_not_told(differences):
    assert differences("{trigger: enters, entity: Y2, zone: left}", keyframes=OUTSIDE) == [MISSING]
    assert differences("{trigger: leaves, entity: Y2, zone: left}", keyframes=OUTSIDE) == [MISSING]


def test_where_nothing_is_missing_nothing_is_told(differences):
    trigger = "{trigger: enters, entity: Y1, zone: left}"
    assert differences(trigger, keyframes=OUTSIDE, expected="events: []") == []
    (one,) = differences(trigger, keyframes=OUTSIDE, expected="events: [], score: {yellow: 1}")
    assert "note" not in one


def test_a_rule_that_has_fired_is_not_told(differences):
    walks_in = OUTSIDE[:-1] + ", {at_s: 0.8, place: {Y1: [0.4, 0]}}, {at_s: 0.9, place: {Y1: [-0.4, 0]}}]"
    trigger = "{trigger: enters, entity: Y1, zone: left}"
    two = "events: [{event: THERE}, {event: THERE}]"
    assert differences(trigger, keyframes=walks_in, expected=two) == ["missing: THERE, event 2 of the test"]
