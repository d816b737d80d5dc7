"""What the sheet says in general about rules, in cases that the referee judges."""

import pytest

from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.load import load_text
from tests.views.sheets import HEAD

E = "actions: [{action: emit, event: E}]"
STILL = "keyframes: [{at_s: 0.05, place: {Y3: [-0.1, -0.5, 0]}}]"


def judge(text: str) -> None:
    """Let the referee judge the tests in a scenario."""
    loaded = load_text(HEAD + text)
    assert {name: list(run_test(loaded, name).differences) for name in loaded.scenario.expect} == {"it": []}


def test_interval_does_not_begin_with_a_firing():
    judge(f"""
rules:
  it: {{triggers: [{{trigger: holds, condition: {{condition: half, at_least: 1}}, every_s: 3}}], {E}}}
expect:
  it: {{lasts_s: 7, {STILL}, events: [{{event: E, at_s: 3.008}}, {{event: E, at_s: 6.016}}]}}
""")


ZONES = """
zones:
  a: {shape: rect, x_min_m: -0.3, x_max_m: -0.1, y_min_m: -0.3, y_max_m: 0.3}
  b: {shape: %s}
"""
BESIDE = "rect, x_min_m: -0.1, x_max_m: 0.1, y_min_m: -0.3, y_max_m: 0.3"
APART = "circle, centre_m: [0.3, 0], radius_m: 0.1"


def test_moving_between_two_zones_of_one_trigger_is_not_entering():
    judge(f"""{ZONES % BESIDE}
rules:
  it: {{triggers: [{{trigger: enters, entity: ball, zone: [a, b]}}], {E}}}
expect:
  it:
    lasts_s: 2
    keyframes: [{{at_s: 0.1, place: {{ball: [0, 0.5]}}}}, {{at_s: 0.5, place: {{ball: [-0.2, 0.1]}}}},
                {{at_s: 1, move: {{ball: [0, 0.1]}}}}]
    events: [{{event: E, at_s: 0.5}}]
""")


@pytest.mark.parametrize(
    ("rule", "before"),
    [
        ("for_each: ab, triggers: [{trigger: enters, entity: ball, zone: each}]", "{event: E}, "),
        ("triggers: [{trigger: enters, entity: ball, zone: hot}]", ""),
    ],
)
def test_one_zone_at_a_time_is_entered_from_the_next_one_too(rule: str, before: str):
    judge(f"""{ZONES % BESIDE}
  c: {{shape: rect, x_min_m: 0, x_max_m: 0.1, y_min_m: -0.3, y_max_m: 0.3}}
groups: {{ab: [a, b]}}
draws: {{hot: {{values: [b, c]}}}}
rules:
  it: {{{rule}, {E}}}
expect:
  it:
    lasts_s: 2
    draws: {{hot: b}}
    keyframes: [{{at_s: 0.1, place: {{ball: [0, 0.5]}}}}, {{at_s: 0.5, place: {{ball: [-0.2, 0.1]}}}},
                {{at_s: 1, move: {{ball: [-0.05, 0.1]}}}}]
    events: [{before}{{event: E}}]
""")


def test_another_place_of_the_step_reached_last_breaks_no_sequence():
    judge(f"""{ZONES % APART}
  c: {{shape: rect, x_min_m: -0.05, x_max_m: 0.1, y_min_m: -0.3, y_max_m: 0.3}}
sequences: {{way: {{entity: ball, steps: [{{any_of: [a, c]}}, b], wrong_step: break}}}}
rules:
  it: {{triggers: [{{trigger: sequence_broken, sequence: way}}], {E}}}
expect:
  it:
    lasts_s: 2
    keyframes: [{{at_s: 0.1, place: {{ball: [0, 0.5]}}}}, {{at_s: 0.5, place: {{ball: [-0.2, 0.1]}}}},
                {{at_s: 1, place: {{ball: [0, 0.1]}}}}]
    events: []
""")


WAITS = """
phases: {pause: {lasts_s: 1}}
rules:
  it:
    triggers: [{trigger: time_reached, at_s: 1}]
    %sactions: [{action: place, entity: ball, at: {point: [0, 0]}}, {action: set_phase, phase: pause}]
"""


@pytest.mark.parametrize(("phases", "x_m"), [("", 0.3), ("phases: any\n    ", 0)])
def test_what_waits_for_room_waits_for_a_phase_of_its_rule_too(phases: str, x_m: float):
    judge(f"""{WAITS % phases}
expect:
  it:
    lasts_s: 1.5
    keyframes: [{{at_s: 0.1, place: {{ball: [0.3, {x_m}], Y1: [0, 0, 0]}}}}, {{at_s: 1.2, place: {{Y1: [-0.3, -0.3, 0]}}}}]
    poses: {{ball: [{x_m}, {x_m}]}}
""")


def test_what_comes_back_after_a_time_waits_for_no_phase():
    judge(f"""
phases: {{pause: {{lasts_s: 9}}}}
rules:
  off:
    triggers: [{{trigger: time_reached, at_s: 1}}]
    actions: [{{action: remove, entity: ball, for_s: 0.5, back_at: {{point: [0, 0]}}}}, {{action: set_phase, phase: pause}}]
  put: {{triggers: [{{trigger: event, event: E}}], actions: [{{action: place, entity: Y1, at: start}}]}}
  say: {{triggers: [{{trigger: time_reached, at_s: 8}}], {E}}}
expect:
  it:
    lasts_s: 3
    keyframes: [{{at_s: 0.1, place: {{Y1: [0, 0, 0]}}}}, {{at_s: 2, place: {{Y1: [-0.3, -0.3, 0]}}}}]
    poses: {{ball: [0, 0]}}
""")


FREE = """
spots: {p: {x_m: 0.3, y_m: 0}, q: {x_m: -0.3, y_m: 0}}
groups: {ps: [p, q]}
obstacles: {vase: {shape: cylinder, centre_m: [0.32, 0], radius_m: 0.02, movable: true}}
rules:
  it: {triggers: [{trigger: time_reached, at_s: 1}], actions: [%s]}
"""
PUT = "{action: place, entity: %s, at: {nearest_free: ps}}"


def test_an_obstacle_beside_a_spot_does_not_keep_it_from_being_free_for_itself():
    judge(f"""{FREE % (PUT % "vase")}
expect: {{it: {{lasts_s: 1.5, {STILL}, poses: {{vase: [0.3, 0]}}}}}}
""")


def test_of_robots_and_obstacles_that_are_put_on_free_spots_the_robots_count_themselves():
    judge(f"""{FREE % f"{PUT % 'vase'}, {PUT % 'Y1'}"}
expect: {{it: {{lasts_s: 1.5, {STILL}, poses: {{vase: [0.3, 0]}}}}}}
""")


def test_time_that_comes_again_measures_each_time_anew():
    judge(f"""
rules:
  it:
    triggers: [{{trigger: time_reached, at_s: 1, every_s: 1}}]
    actions: [{{action: emit, event: E, payload: {{s: {{word: measured}}}}}}]
expect:
  it: {{lasts_s: 2.5, {STILL}, events: [{{event: E, payload: {{s: 1}}}}, {{event: E, payload: {{s: 2}}}}]}}
""")


def test_timers_go_on_while_a_phase_stops_the_clock():
    judge(f"""
phases: {{pause: {{lasts_s: 2, clock: stops}}}}
timers: {{long: {{lasts_s: 2, starts: true}}}}
result: {{rank: [{{time: ascending}}]}}
rules:
  go: {{triggers: [{{trigger: time_reached, at_s: 1}}], actions: [{{action: set_phase, phase: pause}}]}}
  it: {{triggers: [{{trigger: time_reached, at_s: 2}}], phases: any, {E}}}
  long: {{triggers: [{{trigger: timer_expired, timer: long}}], phases: any, actions: [{{action: emit, event: LONG}}]}}
expect:
  it: {{lasts_s: 5, {STILL}, events: [{{event: LONG, at_s: 2.016}}, {{event: E, at_s: 4.032}}]}}
""")


@pytest.mark.parametrize(
    "condition",
    [
        "in_zone, entity: yellow, zone: half, of: all",
        "speed, entity: [Y2, Y3, Y1], of: all, at_most: 1",
        "distance, entity: Y1, to: ball, at_most: 0.01, negate: true",
        "speed, entity: Y1, at_most: 0.1, negate: true",
    ],
)
def test_conditions_ignore_what_is_off_the_field(condition: str):
    judge(f"""
zones: {{half: {{shape: rect, y_max_m: 0}}}}
rules:
  it: {{triggers: [{{trigger: time_reached, at_s: 1}}], conditions: [{{condition: {condition}}}], {E}}}
  off: {{triggers: [{{trigger: time_reached, at_s: 0.5}}], actions: [{{action: remove, entity: Y1}}]}}
expect:
  it: {{lasts_s: 2, {STILL}, events: [{{event: E}}]}}
""")


@pytest.mark.parametrize(
    ("to", "gone", "fires"),
    [
        ("blue", "B1", False),  # B2 is near enough
        ("blue", "blue", True),
        ("yellow", "yellow", True),
        ("yellow", "[Y2, Y3]", True),
        ("B1", "B1", True),
    ],
)
def test_of_a_group_the_others_count_while_the_nearest_is_off_the_field(to: str, gone: str, fires: bool):
    judge(f"""
rules:
  it:
    triggers: [{{trigger: time_reached, at_s: 1}}]
    conditions: [{{condition: distance, entity: Y1, to: {to}, at_most: 0.1, negate: true}}]
    {E}
  off: {{triggers: [{{trigger: time_reached, at_s: 0.5}}], actions: [{{action: remove, entity: {gone}}}]}}
expect:
  it:
    lasts_s: 2
    keyframes: [{{at_s: 0.1, place: {{Y1: [0, 0.3], B1: [0, 0.33], B2: [0, 0.25], Y2: [0.05, 0.3]}}}}]
    events: [{"{event: E}" * fires}]
""")


def test_it_is_the_centre_that_counts():
    judge(f"""{ZONES % APART}
rules:
  it: {{triggers: [{{trigger: enters, entity: ball, zone: a}}], {E}}}
expect:
  it:
    lasts_s: 2
    keyframes: [{{at_s: 0.1, place: {{ball: [0, 0.2]}}}}, {{at_s: 0.5, move: {{ball: [-0.095, 0.2]}}}},
                {{at_s: 1, move: {{ball: [-0.105, 0.2]}}}}]
    events: [{{event: E, at_s: 0.768}}]
""")


def test_what_must_last_begins_anew_after_another_phase():
    judge(f"""
phases: {{pause: {{lasts_s: 1}}}}
rules:
  go: {{triggers: [{{trigger: time_reached, at_s: 3}}], actions: [{{action: set_phase, phase: pause}}]}}
  it: {{triggers: [{{trigger: no_progress, entity: Y1, distance_m: 0.5, within_s: 4}}], {E}}}
expect:
  it: {{lasts_s: 9, {STILL}, events: [{{event: E, at_s: 8.064}}]}}
""")


EVERY_S = "triggers: [{trigger: time_reached, at_s: 1, every_s: 1}]"


def test_of_rules_that_exclude_each_other_one_that_has_reached_its_limit_keeps_no_other_from_counting():
    judge(f"""
rules:
  a: {{exclusive: x, max_executions: 1, {EVERY_S}, actions: [{{action: emit, event: A}}]}}
  b: {{exclusive: x, {EVERY_S}, {E}}}
expect:
  it: {{lasts_s: 2.5, {STILL}, events: [{{event: A}}, {{event: E, at_s: 2.016}}]}}
""")


TIMER = """
timers: {rest: {lasts_s: 1%s}}
rules:
  go: {triggers: [{trigger: time_reached, at_s: 2}], actions: [{action: timer, timer: rest, do: start}]}
  it: {triggers: [{trigger: timer_expired, timer: rest}], actions: [{action: emit, event: E}]}
expect:
  it: {lasts_s: 5, %s, events: [{event: E, at_s: %s}]}
"""


@pytest.mark.parametrize(("starts", "at_s"), [(", starts: true", 1.024), ("", 3.04)])
def test_a_timer_that_is_started_goes_on_or_begins_but_not_when_it_has_run_out(starts: str, at_s: float):
    judge(TIMER % (starts, STILL, at_s))


def test_a_sequence_that_is_complete_stands_at_its_last_step_until_the_next():
    judge(f"""{ZONES % APART}
sequences: {{way: {{entity: ball, steps: [a, b]}}}}
rules:
  it:
    triggers: [{{trigger: time_reached, at_s: 3}}]
    conditions: [{{condition: sequence_at, sequence: way, step: b}}]
    {E}
expect:
  it:
    lasts_s: 4
    keyframes: [{{at_s: 0.5, place: {{ball: [-0.2, 0.1]}}}}, {{at_s: 1, place: {{ball: [0.3, 0.05]}}}}]
    events: [{{event: E}}]
""")


def test_the_last_to_touch_something_is_a_robot_whatever_else_it_rolls_against():
    judge(f"""
balls: {{other_ball: {{start_m: [0.5, 0]}}}}
rules:
  it:
    triggers: [{{trigger: time_reached, at_s: 1}}]
    conditions: [{{condition: last_touch, entity: ball, by: Y1}}]
    {E}
expect:
  it:
    lasts_s: 2
    keyframes: [{{at_s: 0.2, touch: [[ball, Y1]]}}, {{at_s: 0.5, touch: [[ball, other_ball]]}}]
    events: [{{event: E}}]
""")


def test_sequence_stands_at_a_place_that_is_also_its_last_step():
    judge(f"""{ZONES % APART}
sequences: {{way: {{entity: ball, steps: [a, b, a]}}}}
rules:
  it:
    triggers: [{{trigger: time_reached, at_s: 1}}]
    conditions: [{{condition: sequence_at, sequence: way, step: a}}]
    {E}
expect:
  it:
    lasts_s: 2
    keyframes: [{{at_s: 0.5, place: {{ball: [-0.2, 0.1]}}}}]
    events: [{{event: E, at_s: 1}}]
""")
