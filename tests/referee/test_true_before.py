"""A test that fails says which rules waited for a condition to come true that was true already."""

import pytest

from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.load import Loaded
from rcj_challenges.scenario.roster import Roster

# Y1 starts at (-0.4, -0.5), in the zone left.
RULES = """
rules:
  there:
    triggers: [{trigger: holds, condition: {condition: in_zone, entity: Y1, zone: left}}]
    actions: [{action: emit, event: THERE}]
"""
STANDS = "keyframes: [{at_s: 0.5}]"
MISSING = "missing: THERE, event 1 of the test"
NOTE = "note: there waits for a condition to come true that held already at 0 s; with for_s: 0.05 that is heard too"


@pytest.fixture
def differences(small):
    def run(block: str, *more: str) -> list[str]:
        scenario = small(RULES, *more, f"expect: {{it: {{lasts_s: 1, {block}}}}}")
        return list(run_test(Loaded(scenario, Roster.of(scenario), "test", None, {}), "it").differences)

    return run


class TestWhatWasTrueBefore:
    def test_a_rule_that_could_not_hear_it_is_told(self, differences):
        assert differences(f"{STANDS}, events: [{{event: THERE}}]") == [MISSING, NOTE]

    def test_where_the_test_passes_nothing_is_told(self, differences):
        assert differences(f"{STANDS}, events: []") == []

    def test_with_a_time_it_is_heard(self, differences):
        later = RULES.replace("zone: left}}]", "zone: left}, for_s: 0.05}]")
        assert differences(f"{STANDS}, events: [{{event: THERE}}]", later) == []

    def test_a_rule_that_has_fired_later_is_not_told(self, differences):
        to_and_fro = "keyframes: [{at_s: 0.2, place: {Y1: [0, 0]}}, {at_s: 0.5, place: {Y1: [-0.4, 0]}}]"
        assert differences(f"{to_and_fro}, events: []") == ["superfluous: THERE at 0.512 s"]

    def test_what_a_rule_made_true_by_placing_is_told_with_its_time(self, differences):
        put = """
rules:
  away: {triggers: [{trigger: half_started}], actions: [{action: place, entity: Y1, at: {point: [0.4, 0]}}]}
  put: {triggers: [{trigger: time_reached, at_s: 0.32}], actions: [{action: place, entity: Y1, at: {point: [-0.4, 0]}}]}
"""
        assert differences(f"{STANDS}, events: [{{event: THERE}}]", put) == [
            MISSING,
            NOTE.replace("at 0 s", "at 0.32 s"),
        ]
