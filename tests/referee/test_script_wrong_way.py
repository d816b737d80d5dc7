"""A test of a scenario in which a gate is crossed the wrong way says so, for that is why nothing came."""

import pytest

from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.load import Loaded
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.roster import Roster

# The gate goes from x = 0.65 to x = -0.65, so that forward is towards -y. The ball starts at y = 0, beyond it.
TO_AND_FRO = """
gates: {halfway: {from_m: [0.65, 0.1], to_m: [-0.65, 0.1]}}
sequences:
  round: {entity: ball, steps: [left, halfway]}
rules:
  rounded:
    triggers: [{trigger: sequence_completed, sequence: round}]
    actions: [{action: emit, event: ROUND}]
  down:
    for_each: yellow
    triggers: [{trigger: crosses, entity: each, gate: halfway, direction: forward}]
    actions: [{action: emit, event: DOWN}]
  up:
    triggers: [{trigger: crosses, entity: B1, gate: halfway, direction: backward}]
    actions: [{action: emit, event: UP}]
"""
BACKWARD = "keyframes: [{at_s: 0, place: {ball: [-0.3, -0.2]}}, {at_s: 0.32, place: {ball: [-0.3, 0.2]}}]"
NO_STEP = "note: ball crossed halfway backward at 0.32 s: no step of round, which counts gates crossed forward only"


@pytest.fixture
def differences(small):
    def run(block: str, *more: str) -> list[str]:
        scenario: Scenario = small(TO_AND_FRO, *more, f"expect: {{it: {{lasts_s: 1, {block}}}}}")
        return list(run_test(Loaded(scenario, Roster.of(scenario), "test", None, {}), "it").differences)

    return run


class TestWrongWays:
    def test_a_gate_of_a_sequence_that_was_crossed_backward_is_told(self, differences):
        assert differences(BACKWARD + ", events: [{event: ROUND}]") == [
            "missing: ROUND, event 1 of the test",
            NO_STEP,
        ]

    def test_forward_it_is_a_step_and_nothing_is_told(self, differences):
        forward = (
            "keyframes: [{at_s: 0, place: {ball: [-0.8, 0]}}, {at_s: 0.1, place: {ball: [-0.8, 0.2]}},"
            " {at_s: 0.2, place: {ball: [-0.3, 0.2]}}, {at_s: 0.32, place: {ball: [-0.3, 0]}}]"
        )
        assert differences(forward + ", events: [{event: ROUND}]") == []
        assert differences(forward + ", events: []") == ["superfluous: ROUND at 0.32 s"]

    def test_of_a_sequence_of_each_it_is_told_who_crossed_it(self, differences):
        each = "sequences: {round: {per: yellow, steps: [left, halfway]}}"
        frames = "keyframes: [{at_s: 0, place: {Y2: [0, -0.2]}}, {at_s: 0.32, place: {Y2: [0, 0.2]}}]"
        found = differences(frames + ", events: [{event: ROUND}]", each)
        assert NO_STEP.replace("ball", "Y2") in found

    def test_where_the_test_passes_nothing_is_told(self, differences):
        assert differences(BACKWARD + ", events: []") == []

    def test_a_rule_with_a_direction_does_not_hear_the_other_way(self, differences):
        frames = (
            "keyframes: [{at_s: 0.1, place: {B1: [0.1, 0.2], Y2: [0.3, -0.2]}},"
            " {at_s: 0.32, place: {B1: [0.1, -0.2]}}, {at_s: 0.96, move: {Y2: [0.3, 0.2]}}]"
        )
        assert differences(frames + ", events: [{event: UP}]") == [
            "missing: UP, event 1 of the test",
            "note: B1 crossed halfway forward at 0.32 s: not heard by the rule up, which has direction: backward",
            "note: Y2 crossed halfway backward at 0.832 s: not heard by the rule down, which has direction: forward",
        ]

    def test_where_a_rule_puts_something_is_no_way_through_a_gate(self, differences):
        put = """
rules:
  put:
    triggers: [{trigger: time_reached, at_s: 0.32}]
    actions: [{action: place, entity: ball, at: {point: [-0.3, 0.2]}}]
"""
        start = "keyframes: [{at_s: 0, place: {ball: [-0.3, -0.2]}}], events: [{event: ROUND}]"
        assert differences(start, put) == ["missing: ROUND, event 1 of the test"]

    def test_what_is_off_the_field_crosses_nothing(self, differences):
        off = """
rules:
  taken_off:
    triggers: [{trigger: half_started}]
    actions: [{action: remove, entity: ball}]
"""
        assert differences(BACKWARD + ", events: [{event: ROUND}]", off) == ["missing: ROUND, event 1 of the test"]

    def test_a_gate_that_goes_along_with_something_is_looked_at_where_it_is(self, differences):
        gate = "gates: {halfway: {from_m: [0, -0.2], to_m: [0, 0.2], anchor: B2}}"
        # B2 stands at (-0.4, 0.5) and looks along -y: forward through its gate is from its front to its back.
        frames = (
            "keyframes: [{at_s: 0, place: {ball: [0.4, 0.8]}}, {at_s: 0.32, place: {ball: [-0.4, 0.8]}},"
            " {at_s: 0.64, place: {ball: [-0.4, 0.2]}}]"
        )
        assert differences(frames + ", events: [{event: ROUND}]", gate) == [
            "missing: ROUND, event 1 of the test",
            NO_STEP.replace("0.32", "0.64"),
        ]


COUNTDOWN = """
gates: {halfway: {from_m: [0.65, 0.1], to_m: [-0.65, 0.1]}}
phases: {countdown: {lasts_s: 0.64}}
first_phase: countdown
rules:
  over:
    triggers: [{trigger: crosses, entity: ball, gate: halfway}]
    actions: [{action: emit, event: OVER}]
"""
BEFORE = "keyframes: [{at_s: 0, place: {ball: [0, 0.2]}}, {at_s: 0.32, place: {ball: [0, 0]}}]"


class TestTheCourseOfThePhases:
    @pytest.fixture
    def differences(self, small):
        def run(block: str, more: str = "") -> list[str]:
            scenario: Scenario = small(COUNTDOWN, more, f"expect: {{it: {{lasts_s: 2, {block}}}}}")
            return list(run_test(Loaded(scenario, Roster.of(scenario), "test", None, {}), "it").differences)

        return run

    def test_what_comes_in_a_phase_in_which_the_rule_does_not_live_is_missing_and_the_phases_are_told(
        self, differences
    ):
        assert differences(BEFORE + ", events: [{event: OVER}]") == [
            "missing: OVER, event 1 of the test",
            "note: the phase was countdown until 0.64 s, then play",
        ]

    def test_where_nothing_is_missing_nothing_is_told_of_phases(self, differences):
        assert differences(BEFORE + ", score: {yellow: 1}") == ["score of yellow: expected 1, is 0"]

    def test_of_many_phases_the_first_are_told(self, differences):
        to_and_fro = "phases: {countdown: {lasts_s: 0.32, next: pause}, pause: {lasts_s: 0.32, next: countdown}}"
        (_, note) = differences(BEFORE + ", events: [{event: OVER}]", to_and_fro)
        assert note == (
            "note: the phase was countdown until 0.32 s, then pause until 0.64 s, then countdown until 0.96 s, then pause "
            "until 1.28 s, then countdown until 1.6 s, then pause, …"
        )
