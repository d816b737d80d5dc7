"""What a rule sheet says of a case is what the referee makes of the same case."""

import pytest

from rcj_challenges.referee.trials import run_expectation
from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.sheet import sheet_markdown
from tests.views.sheets import HEAD, sentence

pytestmark = pytest.mark.usefixtures("without_drawing")

E = "actions: [{action: emit, event: E}]"
STILL = "keyframes: [{at_s: 0.05, place: {Y3: [-0.1, -0.5, 0]}}]"


def judged(text: str) -> str:
    """Let the referee judge the tests in a scenario, and return its sheet."""
    loaded = load_text(HEAD + text)
    assert {name: run_expectation(loaded, name) for name in loaded.scenario.expect} == {"it": []}
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
