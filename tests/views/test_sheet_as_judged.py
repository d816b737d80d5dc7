"""What a rule sheet says of a case is what the referee makes of the same case."""

import pytest

from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.sheet import sheet_markdown
from tests.views.sheets import HEAD, sentence, sheet

pytestmark = pytest.mark.usefixtures("without_drawing")

E = "actions: [{action: emit, event: E}]"
STILL = "keyframes: [{at_s: 0.05, place: {Y3: [-0.1, -0.5, 0]}}]"


def judged(text: str) -> str:
    """Let the referee judge the tests in a scenario, and return its sheet."""
    loaded = load_text(HEAD + text)
    assert {name: list(run_test(loaded, name).differences) for name in loaded.scenario.expect} == {"it": []}
    return sheet_markdown(loaded.scenario, loaded.roster).replace("\\", "")


def test_what_comes_every_so_often_does_not_come_when_the_half_starts():
    text = judged(f"""
rules:
  it: {{triggers: [{{trigger: holds, condition: {{condition: half, at_least: 1}}, every_s: 3}}], {E}}}
expect:
  it: {{lasts_s: 7, {STILL}, events: [{{event: E, at_s: 3.008}}, {{event: E, at_s: 6.016}}]}}
""")
    assert "1. [it] When 3 s have passed, and again every 3 s: E is announced." in text


ZONES = """
zones:
  a: {shape: rect, x_min_m: -0.3, x_max_m: -0.1, y_min_m: -0.3, y_max_m: 0.3}
  b: {shape: %s}
"""
BESIDE = "rect, x_min_m: -0.1, x_max_m: 0.1, y_min_m: -0.3, y_max_m: 0.3"
APART = "circle, centre_m: [0.3, 0], radius_m: 0.1"


def test_who_goes_from_one_of_several_zones_that_meet_into_the_other_has_not_entered_them():
    text = judged(f"""{ZONES % BESIDE}
rules:
  it: {{triggers: [{{trigger: enters, entity: ball, zone: [a, b]}}], {E}}}
expect:
  it:
    lasts_s: 2
    keyframes: [{{at_s: 0.1, place: {{ball: [0, 0.5]}}}}, {{at_s: 0.5, place: {{ball: [-0.2, 0.1]}}}},
                {{at_s: 1, move: {{ball: [0, 0.1]}}}}]
    events: [{{event: E, at_s: 0.5}}]
""")
    assert "1. [it] When the ball enters the zone “a” or the zone “b” from outside both: E is announced." in text


@pytest.mark.parametrize(
    ("other", "more", "zone", "words"),
    [
        (APART, "", "[a, b]", "the zone “a” or the zone “b”: "),
        (BESIDE, "groups: {ab: [a, b]}\n", "ab", "one of the zones “ab” from outside both: "),
        ("half_plane, through_m: [0, 0], normal: [0, 1]", "", "[a, b]", "the zone “a” or the zone “b” from outside both: "),
        ("circle, centre_m: [0.3, 0], radius_m: 0.1, inverted: true", "", "[a, b]", "or the zone “b” from outside both: "),
        (BESIDE, "", "[a, b, blue_goal]", "the zone “b” or the blue goal from outside all of them: "),
        (BESIDE, "", "a", "enters the zone “a”: "),
    ],
)  # fmt: skip
def test_that_zones_are_entered_as_one_is_said_where_they_meet(other: str, more: str, zone: str, words: str):
    assert words in sentence(f"triggers: [{{trigger: enters, entity: ball, zone: {zone}}}], {E}", ZONES % other + more)


@pytest.mark.parametrize(
    ("rule", "words", "before"),
    [
        (
            "for_each: ab, triggers: [{trigger: enters, entity: ball, zone: each}]",
            "the ball enters it:",
            "{event: E}, ",
        ),
        (
            "triggers: [{trigger: enters, entity: ball, zone: hot}]",
            "enters the zone drawn as “hot” (the zone “b” or the zone “c”):",
            "",
        ),
    ],
)
def test_one_zone_at_a_time_is_entered_from_the_next_one_as_well(rule: str, words: str, before: str):
    assert words in judged(f"""{ZONES % BESIDE}
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


def test_of_one_zone_or_a_drawn_one_both_are_left_where_they_may_meet():
    words = "enters the zone “a” or the zone drawn as “hot” (the zone “b” or the blue goal) from outside both: "
    more = "draws: {hot: {values: [b, blue_goal]}}\n"
    assert words in sentence(
        f"triggers: [{{trigger: enters, entity: ball, zone: [a, hot]}}], {E}", ZONES % BESIDE + more
    )


def test_another_place_of_the_step_reached_last_breaks_no_sequence():
    text = judged(f"""{ZONES % APART}
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
    assert (
        "after the first step, entering one of these which belongs neither to the step reached last nor to the next "
        "breaks it: it begins anew."
    ) in text


WAITS = """
phases: {pause: {lasts_s: 1}}
rules:
  it:
    triggers: [{trigger: time_reached, at_s: 1}]
    %sactions: [{action: place, entity: ball, at: {point: [0, 0]}}, {action: set_phase, phase: pause}]
"""


@pytest.mark.parametrize(
    ("phases", "x_m", "words"),
    [
        ("", 0.3, "it is put there as soon as the place is free in a phase in which that rule counts."),
        ("phases: any\n    ", 0, "it is put there as soon as the place is free.\n"),
    ],
)
def test_what_waits_for_room_waits_for_a_phase_of_its_rule_as_well(phases: str, x_m: float, words: str):
    assert words in judged(f"""{WAITS % phases}
expect:
  it:
    lasts_s: 1.5
    keyframes: [{{at_s: 0.1, place: {{ball: [0.3, {x_m}], Y1: [0, 0, 0]}}}}, {{at_s: 1.2, place: {{Y1: [-0.3, -0.3, 0]}}}}]
    poses: {{ball: [{x_m}, {x_m}]}}
""")


def test_what_is_laid_out_waits_for_a_phase_of_its_rule_as_well():
    rule = WAITS.replace("{action: place, entity: ball, at: {point: [0, 0]}}", "{action: place, layout: all}")
    layout = "placements: {all: [{entity: ball, at: {point: [0, 0]}}]}\n"
    assert "as soon as the place is free in a phase in which that rule counts." in sheet(layout + rule % "")


def test_what_comes_back_after_a_time_waits_for_no_phase():
    text = judged(f"""
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
    assert "in a phase in which that rule counts; what comes back after its time waits for no phase." in text


FREE = """
spots: {p: {x_m: 0.3, y_m: 0}, q: {x_m: -0.3, y_m: 0}}
groups: {ps: [p, q]}
obstacles: {vase: {shape: cylinder, centre_m: [0.32, 0], radius_m: 0.02, movable: true}}
rules:
  it: {triggers: [{trigger: time_reached, at_s: 1}], actions: [%s]}
"""
PUT = "{action: place, entity: %s, at: {nearest_free: ps}}"


def test_an_obstacle_beside_a_spot_does_not_keep_it_from_being_free_for_itself():
    text = judged(f"""{FREE % (PUT % "vase")}
expect: {{it: {{lasts_s: 1.5, {STILL}, poses: {{vase: [0.3, 0]}}}}}}
""")
    assert "nearer to it than 8 cm; what is to be put there must have room." in text


def test_of_robots_and_obstacles_that_are_put_on_free_spots_the_robots_count_themselves():
    text = judged(f"""{FREE % f"{PUT % 'vase'}, {PUT % 'Y1'}"}
expect: {{it: {{lasts_s: 1.5, {STILL}, poses: {{vase: [0.3, 0]}}}}}}
""")
    assert (
        "nearer to it than 8 cm; a robot or a ball that is to be put there counts as well where it is now, and what is "
        "put there must have room."
    ) in text


def test_what_a_time_that_comes_again_has_measured_is_not_known_before():
    text = judged(f"""
rules:
  it:
    says: "{{measured}} s are over"
    triggers: [{{trigger: time_reached, at_s: 1, every_s: 1}}]
    actions: [{{action: emit, event: E, payload: {{s: {{word: measured}}}}}}]
expect:
  it: {{lasts_s: 2.5, {STILL}, events: [{{event: E, payload: {{s: 1}}}}, {{event: E, payload: {{s: 2}}}}]}}
""")
    assert "1. [it] … s are over. When the half has lasted 1 s, and again" in text


def test_where_a_phase_stops_the_clock_times_are_those_of_the_clock_and_timers_go_on():
    text = judged(f"""
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
    assert "then “play” follows; the clock stands still, timers go on.\n" in text
    assert "[it] When the clock of the half has reached 2 s: E is announced" in text
    assert "The better one has a shorter time (also counted while the clock stands still)." in text
    assert "timers" not in sheet("phases: {pause: {lasts_s: 2, clock: stops}}\n")
    assert "When the half has lasted 2 s: " in sentence(f"triggers: [{{trigger: time_reached, at_s: 2}}], {E}")


@pytest.mark.parametrize(
    ("condition", "words"),
    [
        ("in_zone, entity: yellow, zone: half, of: all", "all of the yellow robots on the field are in the half"),
        ("speed, entity: [Y2, Y3, Y1], of: all, at_most: 1", "all of Y2, Y3 and Y1 on the field move at a speed of at most 1 m/s"),
        ("in_zone, entity: [Y1, Y2], zone: half, of: all", "both Y1 and Y2 (of those on the field) are in the half"),
        ("distance, entity: Y1, to: ball, at_most: 0.01, negate: true",
         "Y1 is more than 0.01 m from the ball or off the field"),
        ("speed, entity: Y1, at_most: 0.1, negate: true", "Y1 moves faster than 0.1 m/s or is off the field"),
    ],
)  # fmt: skip
def test_who_is_off_the_field_is_asked_for_nothing_and_that_is_said(condition: str, words: str):
    text = judged(f"""
zones: {{half: {{shape: rect, y_max_m: 0}}}}
rules:
  it: {{triggers: [{{trigger: time_reached, at_s: 1}}], conditions: [{{condition: {condition}}}], {E}}}
  off: {{triggers: [{{trigger: time_reached, at_s: 0.5}}], actions: [{{action: remove, entity: Y1}}]}}
expect:
  it: {{lasts_s: 2, {STILL}, events: [{{event: E}}]}}
""")
    assert f"provided that {words}: E is announced." in text


@pytest.mark.parametrize(
    ("to", "gone", "words", "fires"),
    [
        ("blue", "B1", "from the nearest of the blue robots", False),  # B2 is near enough
        ("blue", "blue", "from the nearest of the blue robots, or all of the blue robots are off the field", True),
        ("yellow", "yellow", "from the nearest other one of the yellow robots, or off the field, or all of the others are",
         True),
        ("yellow", "[Y2, Y3]", "from the nearest other one of the yellow robots, or all of the others are off the field",
         True),
        ("B1", "B1", "from B1, or B1 is off the field", True),
    ],
)  # fmt: skip
def test_of_a_group_the_others_count_while_the_nearest_is_off_the_field(to: str, gone: str, words: str, fires: bool):
    text = judged(f"""
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
    assert f"provided that Y1 is more than 0.1 m {words}: E is announced." in text


@pytest.mark.parametrize(
    ("halves", "keep", "words"),
    [
        (1, "", "west or east, never the same twice running."),
        (2, "", "west or east, in a half never the same twice running."),
        (2, ", keep: match", "west or east, never the same twice running."),
    ],
)
def test_what_was_drawn_in_the_half_before_may_come_again(halves: int, keep: str, words: str):
    text = sheet(f"""
match: {{halves: {halves}}}
draws: {{side: {{values: [west, east], not_last: true{keep}}}}}
rules:
  it: {{triggers: [{{trigger: enters, entity: ball, zone: blue_goal}}], actions: [{{action: draw, draw: side}}]}}
""")
    assert f"and again when a rule says so: {words}\n" in text


CENTRE = "Where a robot, a ball or an obstacle is, its centre says: "


def test_it_is_the_centre_that_counts():
    text = judged(f"""{ZONES % APART}
rules:
  it: {{triggers: [{{trigger: enters, entity: ball, zone: a}}], {E}}}
expect:
  it:
    lasts_s: 2
    keyframes: [{{at_s: 0.1, place: {{ball: [0, 0.2]}}}}, {{at_s: 0.5, move: {{ball: [-0.095, 0.2]}}}},
                {{at_s: 1, move: {{ball: [-0.105, 0.2]}}}}]
    events: [{{event: E, at_s: 0.768}}]
""")
    assert f"{CENTRE}it counts for zones and gates, and distances are measured from it." in text
    assert CENTRE not in sheet(f"rules: {{it: {{triggers: [{{trigger: half_started}}], {E}}}}}\n")


def test_what_must_last_begins_anew_after_another_phase():
    text = judged(f"""
phases: {{pause: {{lasts_s: 1}}}}
rules:
  go: {{triggers: [{{trigger: time_reached, at_s: 3}}], actions: [{{action: set_phase, phase: pause}}]}}
  it: {{triggers: [{{trigger: no_progress, entity: Y1, distance_m: 0.5, within_s: 4}}], {E}}}
expect:
  it: {{lasts_s: 9, {STILL}, events: [{{event: E, at_s: 8.064}}]}}
""")
    assert (
        "is not made up for later, and what must last for a time, or move within one, is measured anew after it.\n"
        in text
    )
    goes_on = f"triggers: [{{trigger: no_progress, entity: Y1, distance_m: 0.5, within_s: 4}}], {E}"
    assert "measured anew" not in sheet(
        f"phases: {{pause: {{lasts_s: 1}}}}\nrules: {{it: {{phases: any, {goes_on}}}}}\n"
    )


def test_angles_are_told_to_a_tenth_of_a_degree():
    text = sentence(f"triggers: [{{trigger: tips_over, entity: Y1, angle_rad: 0.5}}], {E}")
    assert "When Y1 tilts by more than 28.6°: " in text


EVERY_S = "triggers: [{trigger: time_reached, at_s: 1, every_s: 1}]"


def test_of_rules_that_exclude_each_other_one_that_has_reached_its_limit_keeps_no_other_from_counting():
    text = judged(f"""
rules:
  a: {{exclusive: x, max_executions: 1, {EVERY_S}, actions: [{{action: emit, event: A}}]}}
  b: {{exclusive: x, {EVERY_S}, {E}}}
expect:
  it: {{lasts_s: 2.5, {STILL}, events: [{{event: A}}, {{event: E, at_s: 2.016}}]}}
""")
    both = "When both [a] and [b] happen in the same tick, "
    assert f"{both}only the first of them in the list above counts that still may." in text


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
    assert "2 s: the timer “rest” starts or goes on, unless it has run out." in judged(TIMER % (starts, STILL, at_s))


def test_a_sequence_that_is_complete_stands_at_its_last_step_until_the_next():
    text = judged(f"""{ZONES % APART}
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
    assert "the sequence “way” stands at the zone “b” (complete, until its next step): E is announced." in text


def test_the_last_to_touch_something_is_a_robot_whatever_else_it_rolls_against():
    text = judged(f"""
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
    assert "The last to touch something is the robot that touched it last since a rule put it where it is; if " in text


def test_a_last_step_that_comes_before_as_well_does_not_say_that_the_sequence_is_complete():
    text = judged(f"""{ZONES % APART}
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
    assert "stands at the zone “a” (also when it is complete, until its next step): E is announced." in text


@pytest.mark.parametrize(("step", "cyclic"), [("a", "false"), ("b", "true")])
def test_at_a_step_that_completes_nothing_a_sequence_merely_stands(step: str, cyclic: str):
    way = f"sequences: {{way: {{entity: ball, steps: [a, b], cyclic: {cyclic}}}}}\n"
    asks = f"conditions: [{{condition: sequence_at, sequence: way, step: {step}}}]"
    said = sentence(f"triggers: [{{trigger: time_reached, at_s: 1}}], {asks}, {E}", ZONES % APART + way)
    assert said.endswith(f"provided that the sequence “way” stands at the zone “{step}”: E is announced.")
