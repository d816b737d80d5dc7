"""How things come back that were taken off the field for a time, and how long an absence still counts as presence."""

import pytest

from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.load import load, load_text

HEAD = "schema_version: 1\nid: ways_back\ntitle: Ways back\nextends: soccersim_v2\n"

NO_ROOM = (
    HEAD
    + """
rules:
  off:
    triggers: [{trigger: time_reached, at_s: 1.6}]
    actions: [{action: remove, entity: Y1, for_s: 3.2, back_at: {point: [-0.5, 0]}}]
  try_earlier:
    triggers: [{trigger: time_reached, at_s: 2.56}]
    actions: [{action: place, entity: Y1, at: {point: [0.4, 0.5]}, on_failure: stay}]
expect:
  it:
    keyframes: [{at_s: 1, place: {B1: [0.4, 0.5]}}]
    lasts_s: 5
    poses: {Y1: [-0.5, 0]}
"""
)

VOID_REMOVAL = (
    HEAD
    + """
rules:
  off:
    triggers: [{trigger: time_reached, at_s: 1.6}]
    actions: [{action: remove, entity: Y1, for_s: 0.64, back_at: {point: [-0.5, 0]}}]
  elsewhere_if_there_is_room:
    triggers: [{trigger: time_reached, at_s: 1.6}]
    actions: [{action: place, entity: Y1, at: {point: [0.4, 0.5]}, on_failure: stay}]
expect:
  it:
    keyframes: [{at_s: 1, place: {B1: [0.4, 0.5], Y1: [0.5, -0.5]}}]
    lasts_s: 5
    poses: {Y1: [0.5, -0.5]}
"""
)

OTHER_PHASE = (
    HEAD
    + """
phases: {second: {}}
rules:
  off:
    triggers: [{trigger: time_reached, at_s: 1.6}]
    actions: [{action: remove, entity: Y1, for_s: 3.2, back_at: {point: [-0.5, 0]}}]
  on:
    triggers: [{trigger: time_reached, at_s: 2.56}]
    actions: [{action: set_phase, phase: second}]
expect:
  it: {keyframes: [{at_s: 0.5}], lasts_s: 5, poses: {Y1: [-0.5, 0]}}
"""
)

HELD_BY_ANOTHER = (
    HEAD
    + """
zones: {west: {shape: rect, x_max_m: 0}}
rules:
  held:
    triggers:
      - trigger: holds
        condition: {condition: in_zone, entity: yellow, zone: west, of: {at_least: 1}}
        for_s: 3.2
    actions: [{action: emit, event: HELD}]
  elsewhere:
    triggers: [{trigger: time_reached, at_s: 2.56}]
    actions: [{action: place, entity: Y3, at: {point: [0.5, 0.1]}}]
expect:
  it:
    keyframes:
      - {at_s: 0.32, place: {Y1: [0.4, -0.5], Y2: [0.4, 0.5], Y3: [0.4, 0.4]}}
      - {at_s: 0.64, place: {Y1: [-0.4, -0.5]}}
    lasts_s: 8
    events: [{event: HELD, at_s: 3.84, tolerance_s: 0.04}]
"""
)

STOPPED_CLOCK = (
    HEAD
    + """
match: {half_s: 6.4}
phases: {warm_up: {lasts_s: 3.2, next: play, clock: stops}}
first_phase: warm_up
rules:
  over: {triggers: [{trigger: half_ended}], phases: any, actions: [{action: emit, event: OVER}]}
expect:
  it: {keyframes: [{at_s: 0.5}], lasts_s: 9.6, ignore: [], events: [{event: OVER, at_s: 9.6}]}
"""
)


@pytest.mark.parametrize(
    "scenario",
    [
        pytest.param(NO_ROOM, id="a place that found no room and gave up does not keep it away"),
        pytest.param(
            VOID_REMOVAL, id="what was placed in the tick of its removal was never off and does not come back"
        ),
        pytest.param(OTHER_PHASE, id="it comes back whatever phase the match is in"),
        pytest.param(HELD_BY_ANOTHER, id="what one of several holds goes on while another is put elsewhere"),
        pytest.param(STOPPED_CLOCK, id="a half whose clock stood still can be tested to its end"),
    ],
)
def test_as_its_name_says(scenario):
    assert run_test(load_text(scenario), "it").differences == ()


@pytest.mark.parametrize(("back_at_s", "called"), [(9.984, True), (10.016, True), (10.048, False)])
def test_more_than_two_seconds_outside_the_penalty_area_start_a_new_stay(back_at_s, called):
    test = "{keyframes: [{at_s: 0.096, place: {B1: [0, 0.65]}}, {at_s: 8.032, place: {B1: [0, 0.4]}}, "
    test += f"{{at_s: {back_at_s}, place: {{B1: [0, 0.65]}}}}], lasts_s: 15.8, score: {{blue: 0}}}}"
    trial = run_test(load("match", ["robot_progress_s=60", f"expect.it={test}"]), "it")
    assert ("inside_penalty_area_too_long" in trial.fired) is called


@pytest.mark.parametrize(("value", "back"), [("0.64", 20), ("0", 1), ("-3", 1)])
def test_a_counter_says_when_it_comes_back(stage, value, back):
    play = stage(
        f"counters: {{away_s: {{initial: {value}}}}}",
        "rules: {r: {triggers: [{trigger: program_fault, robot: Y1}], "
        "actions: [{action: remove, entity: Y1, for_s: {counter: away_s}}]}}",
    )
    play.fail("Y1")
    play.play(100)
    assert [(tick, placed.parked) for tick, placed in play.placements if tick] == [(1, True), (1 + back, False)]
