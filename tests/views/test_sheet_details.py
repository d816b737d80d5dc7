"""The rule sheet leaves out nothing that a team must know: order, obstacles, facing, noise; and says it in English."""

import re

import pytest

from tests.views.sheets import sentence, sheet

pytestmark = pytest.mark.usefixtures("without_drawing")

# --- which rule goes first ------------------------------------------------------------------------------------------

END = "actions: [{action: end}]"


def one_of(name: str, exclusive: str, extra: str = "", trigger: str = "trigger: half_started") -> str:
    return f"  {name}: {{exclusive: {exclusive}, {extra}triggers: [{{{trigger}}}], {END}}}\n"


def test_rules_stand_in_the_order_in_which_they_are_judged():
    text = sheet(
        "rules:\n" + one_of("late", "a", "priority: 5, ") + one_of("first", "a", "priority: -1, ") + one_of("mid", "b")
    )
    assert re.findall(r"^\d\. \[\w+\]", text, re.MULTILINE) == ["1. [first]", "2. [mid]", "3. [late]"]


def test_of_rules_that_exclude_each_other_the_sheet_says_that_only_the_first_counts():
    text = sheet(
        "rules:\n" + one_of("goal", "outcome", "priority: 1, ") + one_of("failed", "outcome") + one_of("alone", "other")
    )
    assert (
        "When both [failed] and [goal] happen in the same tick, only the first of them in the list above counts."
        in text
    )
    assert text.count("[alone]") == 1


def test_of_three_rules_that_exclude_each_other_all_are_named():
    text = sheet("rules:\n" + "".join(one_of(name, "outcome") for name in ("a", "b", "c")))
    assert (
        "When several of [a], [b] and [c] happen in the same tick, only the first of them in the list above counts."
        in text
    )


def test_rules_that_go_over_each_of_a_group_exclude_each_other_for_the_same_member_only():
    moved = "trigger: leaves, entity: each, zone: pitch"
    text = sheet(
        "rules:\n"
        + one_of("still", "moves", "for_each: robots, ", moved)
        + one_of("out", "moves", "for_each: yellow, ", moved)
        + one_of("ball_out", "moves", "", "trigger: leaves, entity: ball, zone: pitch")
    )
    told = "When both [still] and [out] happen for the same robot in the same tick, only the first of them in the list above"
    assert f"{told} counts." in text
    assert text.count("[ball_out]") == 1


def test_rules_over_different_things_never_meet():
    moved = "trigger: leaves, entity: each, zone: pitch"
    text = sheet(
        "rules:\n"
        + one_of("blue_out", "moves", "for_each: blue, ", moved)
        + one_of("yellow_out", "moves", "for_each: yellow, ", moved)
    )
    assert "in the same tick" not in text


# --- the field ------------------------------------------------------------------------------------------------------

OBSTACLES = """
obstacles:
  gate_post: {shape: cylinder, centre_m: [0.45, 0], radius_m: 0.03}
  crate: {shape: box, centre_m: [-0.45, 0], size_m: [0.1, 0.2], yaw_rad: 0.6, height_m: 0.05, movable: true, mass_kg: 0.2}
  fence: {shape: wall, from_m: [-0.6, 0.2], to_m: [-0.3, 0.55]}
"""
RULE = f"rules: {{it: {{triggers: [{{trigger: half_started}}], {END}}}}}\n"


@pytest.mark.parametrize(
    "row",
    [
        "| gate post | (0.45, 0) | cylinder, radius 3 cm | 9 cm | no |",
        "| crate | (-0.45, 0) | box, 0.1 m along its x and 0.2 m along its y, turned by 34.4° | 5 cm | yes, its mass is 0.2 kg |",
        "| fence | from (-0.6, 0.2) to (-0.3, 0.55) | wall, 1 cm thick | 9 cm | no |",
    ],
)
def test_each_obstacle_stands_on_the_sheet(row):
    assert row in sheet(OBSTACLES + RULE)


def test_without_obstacles_there_is_no_table_of_them():
    assert "obstacle" not in sheet(RULE)


def test_the_sheet_says_that_there_are_goals_or_none():
    none = "field: {corner_cut_m: 0.3, goals: {blue_goal: null, yellow_goal: null}}\n"
    zones = "zones: {blue_goal: null, yellow_goal: null}\ngroups: {in_play: null}\n"
    assert "There are no goals." in sheet(none + zones + RULE)
    goals = "The blue goal stands at the +y end, 0.4 m wide and 0.1 m deep, its walls are 0.121 m high; the yellow"
    assert goals in sheet(RULE)


@pytest.mark.parametrize(
    ("cut_m", "words"),
    [(0.3, "Walls at 45° cut 0.3 m off both sides of each corner."), (0, "Its corners are square.")],
)
def test_the_sheet_says_how_the_corners_are_cut(cut_m, words):
    assert words in sheet(f"field: {{corner_cut_m: {cut_m}}}\n" + RULE)


# --- what a rule says -----------------------------------------------------------------------------------------------

WHO = {
    "{trigger: enters, entity: red, zone: pitch}": "The ball “red” is there.",
    "{trigger: enters, entity: Y1, zone: pitch}": "Y1 is there.",
    "{trigger: displaced, entity: blue, distance_m: 0.1}": "One of the blue robots is there.",
    "{trigger: enters, entity: Y1, zone: pitch}, {trigger: leaves, entity: ball, zone: pitch}": "Y1 or the ball “ball” is there.",
    "{trigger: touches, entity: vase, other: ball}": "The obstacle “vase” is there.",
    "{trigger: program_fault, robot: Y2}": "Y2 is there.",
    "{trigger: sequence_completed, sequence: way}": "Y3 is there.",
    "{trigger: sequence_completed, sequence: round}": "One of the blue robots is there.",
    "{trigger: sequence_completed, sequence: round, entity: B2}": "B2 is there.",
    "{trigger: timer_expired, timer: rest}": "One of the robots is there.",
    "{trigger: holds, condition: {condition: in_zone, entity: red, zone: pitch}, for_s: 1}": "The ball “red” is there.",
    "{trigger: time_reached, at_s: 3}": "The one concerned is there.",
}
THINGS = """
balls: {red: {start_m: [0.4, 0]}}
obstacles: {vase: {shape: cylinder, centre_m: [0.4, 0.1], radius_m: 0.02, movable: true}}
timers: {rest: {lasts_s: 3, per: robots}}
sequences: {way: {entity: Y3, steps: [blue_goal, yellow_goal]}, round: {per: blue, steps: [blue_goal, yellow_goal]}}
flags: {away: {}}
"""


@pytest.mark.parametrize(("triggers", "words"), WHO.items(), ids=list(WHO.values()))
def test_a_sentence_without_for_each_names_what_its_trigger_is_about(triggers, words):
    said = sentence(f"triggers: [{triggers}], {END}, says: '{{entity}} is there.'", THINGS)
    assert said.startswith(f"{words} When ")


STILL = "{trigger: holds, condition: {condition: speed, entity: each, at_most: 0.01}, for_s: 5}"


@pytest.mark.parametrize(
    ("trigger", "told"),
    [
        (STILL, "5"),
        (STILL.replace("for_s: 5", "for_s: 5, every_s: 2"), "…"),
        (STILL.replace("for_s: 5", "for_s: 5, grace_s: 1"), "…"),
        (STILL.replace(", for_s: 5", ""), "…"),
        ("{trigger: no_progress, entity: each, distance_m: 0.1, within_s: 5}", "…"),
    ],
)
def test_what_is_measured_only_when_it_happens_is_left_open(trigger, told):
    said = sentence(f"for_each: robots, triggers: [{trigger}], {END}, says: '{{entity}} stood for {{measured}} s.'")
    assert said.startswith(f"The robot stood for {told} s. For each")


def test_the_limit_of_the_trigger_stands_in_the_sentence():
    said = sentence(f"for_each: robots, triggers: [{STILL}], {END}, says: 'More than {{limit}} s.'")
    assert said.startswith("More than 5 s. For each")


def test_the_limit_of_a_timer_is_its_length():
    said = sentence(
        f"triggers: [{{trigger: timer_expired, timer: rest}}], {END}, says: '{{limit}} s are over.'", THINGS
    )
    assert said.startswith("3 s are over. When")


def test_a_limit_that_differs_from_trigger_to_trigger_is_left_open():
    both = "{trigger: time_reached, at_s: 3}, {trigger: time_reached, at_s: 4}"
    assert sentence(f"triggers: [{both}], {END}, says: 'After {{limit}} s.'").startswith("After … s. When")


TEAMS = {
    ("for_each: robots, ", "each", "{entity} of {team} is out."): "The robot is out.",
    ("for_each: yellow, ", "each", "{entity} of {team} is out."): "The robot of yellow is out.",
    ("", "robots", "{entity} of {team} is out."): "One of the robots is out.",
    ("for_each: yellow, ", "each", "{team} is alone on the hill."): "Yellow is alone on the hill.",
    ("", "Y1", "A point for {team}."): "A point for yellow.",
    ("", "robots", "A point for {team}."): "A point for the team.",
    ("", "ball", "A point for {team}."): "A point for the team.",
}


@pytest.mark.parametrize(("rule", "words"), TEAMS.items(), ids=list(TEAMS.values()))
def test_the_team_is_named_if_all_that_the_rule_is_about_are_of_one(rule, words):
    each, entity, says = rule
    trigger = f"{{trigger: enters, entity: {entity}, zone: blue_goal}}"
    assert sentence(f"{each}triggers: [{trigger}], {END}, says: '{says}'").startswith(f"{words} ")


@pytest.mark.parametrize(
    ("says", "words"),
    [
        ("goal", "Goal. When"),
        ("after {measured}", "After …. When"),
        ("Goal!", "Goal! When"),
        ('"goal."', '"goal." When'),
        ("goal (once)", "Goal (once). When"),
    ],
)
def test_what_a_rule_says_ends_before_the_next_sentence_begins(says, words):
    assert sentence(f"triggers: [{{trigger: half_started}}], {END}, says: '{says}'").startswith(words)


# --- where things are put -------------------------------------------------------------------------------------------

PUT = {
    "entity: Y1, at: start, facing: {random: true}": "Y1 is put at its start, facing a random way",
    "entity: Y1, at: start, facing: {towards: ball}": "Y1 is put at its start, facing the ball “ball”",
    "entity: Y1, at: start, facing: {towards: [0, 0]}": "Y1 is put at its start, facing (0, 0)",
    "entity: Y1, at: start, facing: keep": "Y1 is put at its start, facing the way it did before",
    "entity: yellow, at: start, facing: keep": "the yellow robots are put at their starts, each facing the way it did before",
    "entity: Y1, at: start, facing: 1.5708": "Y1 is put at its start, facing 90° counter-clockwise from +x",
    "entity: Y1, at: start, facing: start": "Y1 is put at its start",
    "entity: ball, at: {uniform_in: pitch}, min_clearance_m: 0.05": (
        "the ball “ball” is put anywhere in the pitch, at least 5 cm from everything but the walls"
    ),
    "entity: ball, at: {uniform_in: [pitch, blue_goal]}": "the ball “ball” is put anywhere in the pitch or the blue goal",
    "entity: ball, at: {spot: centre}, on_failure: stay": (
        "the ball “ball” is put on the spot “centre”, or left where it is if there is no room"
    ),
    "entity: [Y1, Y2], at: {spot: centre}, on_failure: stay": (
        "Y1 and Y2 are each put on the spot “centre”, or left where it is if there is no room"
    ),
    "entity: ball, at: {spot: centre}, noise_m: [0.1, 0]": "the ball “ball” is put on the spot “centre” (± 0.1 m in x)",
    "entity: Y1, at: {point: [0.1, 0]}, mirror: {axis: x, when: away}, facing: {towards: ball}": (
        "Y1 is put at (0.1, 0), mirrored (x becomes -x) if the flag “away” is set, facing the ball “ball”"
    ),
    "entity: Y1, at: {relative_to: ball, offset_m: [0, -0.2]}": "Y1 is put 0.2 m towards -y of the ball “ball”",
    "entity: Y1, at: {relative_to: ball, offset_m: [0.1, -0.05]}": (
        "Y1 is put 10 cm towards +x and 5 cm towards -y of the ball “ball”"
    ),
    "entity: ball, at: {relative_to: Y1, offset_m: [0.1, 0.05], turns: true}": (
        "the ball “ball” is put 10 cm to the front and 5 cm to the left of Y1, as Y1 is turned"
    ),
    "entity: Y1, at: {relative_to: Y1, offset_m: [0, 0.2]}": "Y1 is put 0.2 m towards +y of where it is",
    "entity: Y1, at: {relative_to: Y1, offset_m: [0.2, 0], turns: true}": (
        "Y1 is put 0.2 m to the front of where it is, as it is turned"
    ),
    "entity: Y1, at: {relative_to: Y1}, noise_m: [0.1, 0]": "Y1 is put right where it is (± 0.1 m in x)",
    "entity: ball, at: {relative_to: centre}": "the ball “ball” is put right at the spot “centre”",
}


@pytest.mark.parametrize(("written", "words"), PUT.items(), ids=list(PUT.values()))
def test_a_placement_says_where_and_how(written, words):
    said = sentence(f"triggers: [{{trigger: half_started}}], actions: [{{action: place, {written}}}]", THINGS)
    assert said == f"When a half starts: {words}."


def test_what_comes_back_faces_as_the_rule_says():
    back = "{action: remove, entity: Y1, for_s: 4, back_at: {spot: centre}, facing: {random: true}}"
    said = sentence(f"triggers: [{{trigger: half_started}}], actions: [{back}]")
    assert said.endswith("Y1 is taken off the field and after 4 s put on the spot “centre”, facing a random way.")


def test_a_layout_says_how_things_face():
    put = RULE.replace(END, "actions: [{action: place, layout: a}]")
    text = sheet("placements: {a: [{entity: Y1, at: start, facing: {random: true}}]}\n" + put)
    assert "“a”: Y1 is put at its start, facing a random way." in text


# --- devices --------------------------------------------------------------------------------------------------------

DEVICES = {
    "{device: gps, noise_m: 0.02}": "position of the robot (noise: standard deviation 2 cm).",
    "{device: gps}": "position of the robot.",
    "{device: gps, frame: legacy, noise_m: 0.02}": (
        "position of the robot, told as [y, z, x] as in the worlds of 2021 (noise: standard deviation 2 cm)."
    ),
    "{device: compass, frame: legacy}": "direction of north, told as [left, up, ahead] as in the worlds of 2021.",
    "{device: lidar, frame: legacy}": (
        "lidar, 360 points, 1 cm to 3 m, turning at 10 Hz, its points told as [left, up, ahead] as in the worlds of 2021"
        ", 4.25 cm above the floor, clockwise from the front."
    ),
    "{device: compass, noise_rad: 0.1}": "direction of north (noise: standard deviation 5.73°).",
    "{device: sonar, bearing_rad: 0, noise: 0.1}": (
        "distance sensor, bearing 0°, up to 1 m (noise: standard deviation 10 % of the value from 1 m on, less when nearer)"
        ", 3.85 cm off the robot's centre and 5.75 cm above the floor, without an echo of what it meets at 22.5° "
        "or more off the perpendicular."
    ),
    "{device: sonar, bearing_rad: 0, noise: 0, offset_m: 0.1, height_m: 0.02, lost_from_rad: 3}": (
        # Where none is lost nothing is said of it.
        "distance sensor, bearing 0°, up to 1 m, 0.1 m off the robot's centre and 2 cm above the floor."
    ),
    "{device: ball_receiver, range_m: 3, strength_noise: 0.05, direction_noise_rad: 0.02}": (
        "infra-red receiver of the ball, up to 3 m (noise: standard deviation 5 % of the strength and 1.15° of the direction)."
    ),
    "{device: ball_receiver, direction_noise_rad: 0.02}": (
        "infra-red receiver of the ball, up to 0.6 m (noise: standard deviation 1.15° of the direction)."
    ),
    "{device: lidar, rotating: false, noise_m: 0.01}": (
        "lidar, 360 points, 1 cm to 3 m (noise: standard deviation 1 cm), 4.25 cm above the floor, clockwise from "
        "the front."
    ),
    "{device: lidar, field_of_view_rad: 2, height_m: 0.12}": (
        "lidar, 360 points, 1 cm to 3 m, turning at 10 Hz, 0.12 m above the floor, over 114.6° from left to right."
    ),
    "{device: lidar, field_of_view_rad: 2, points: 1}": (
        "lidar, 1 point, 1 cm to 3 m, turning at 10 Hz, 4.25 cm above the floor, straight ahead."
    ),
    "{device: team_emitter, baud: 4800, range_m: 2}": "team radio, sends up to 2 m far, 4800 baud (19.2 bytes in a tick).",
    "{device: motor, wheel: left, direction: -1}": "motor of the left wheel, positive speeds drive backward.",
    "{device: motor, wheel: right}": "motor of the right wheel, positive speeds drive forward.",
    "{device: wheel_sensor, wheel: left, direction: -1}": (
        "angle of the left wheel in rad, grows while the robot drives backward."
    ),
    "{device: team_receiver, range_m: 4}": "team radio, receives from up to 4 m",
}


@pytest.mark.parametrize(("device", "words"), DEVICES.items(), ids=list(DEVICES))
def test_a_device_says_its_range_and_its_noise(device, words):
    text = sheet(f"robots: {{Y1: {{devices: {{it: {device}}}}}}}\n" + RULE)
    assert f"Y1 differs from its kit: “it”: {words}" in text


def test_the_radio_channels_of_the_teams_stand_on_the_sheet():
    text = sheet("entrants: {yellow: {radio_channel: 7}}\n" + RULE)
    assert "Team radio: channel 2 for blue, channel 7 for yellow." in text


def test_the_channel_told_is_the_one_that_is_used():
    text = sheet("entrants: {blue: {radio_channel: 1}}\n" + RULE)
    assert "Team radio: channel 2 for blue, channel 3 for yellow." in text


def test_who_has_no_radio_gets_no_channel():
    mute = "{without: [team receiver, team emitter]}"
    text = sheet(
        f"robots: {{Y1: {mute}, Y2: {mute}, Y3: {{idle: true}}}}\nentrants: {{yellow: {{robots: {{Y3: null}}}}}}\n"
        + RULE
    )
    assert "Team radio: channel 2 for blue." in text


# --- wording --------------------------------------------------------------------------------------------------------

SPEEDS = {
    "entity: ball, at_most: 0.1, negate: true": "the ball moves faster than 0.1 m/s",
    "entity: ball, at_least: 0.1, negate: true": "the ball moves slower than 0.1 m/s",
    "entity: ball, at_most: 0.1": "the ball moves at a speed of at most 0.1 m/s",
    "entity: ball, at_least: 0.1, at_most: 0.3, negate: true": (
        "the ball does not move at a speed of at least 0.1 m/s and at most 0.3 m/s"
    ),
    "entity: robots, at_most: 0.1, negate: true": "none of the robots moves at a speed of at most 0.1 m/s",
}


@pytest.mark.parametrize(("written", "words"), SPEEDS.items(), ids=list(SPEEDS.values()))
def test_the_opposite_of_a_speed_is_a_speed(written, words):
    condition = f"{{condition: speed, {written}}}"
    said = sentence(f"triggers: [{{trigger: half_started}}], conditions: [{condition}], {END}")
    assert said == f"When a half starts, provided that {words}: the half ends."


ZONES = {
    "off_the_ring": "the zone “off the ring”",
    "another_small_zone": "the zone “another small zone”",
    "a_corner": "the zone “a corner”",
    "near": "the zone “near”",
    "far": "the zone “far”",
    "far_away": "the zone “far away”",
    "here": "the zone “here”",
    "nw": "the zone “nw”",
    "the_hill": "the hill",
    "hill": "the hill",
}


@pytest.mark.parametrize(("name", "words"), ZONES.items(), ids=list(ZONES))
def test_a_name_gets_no_second_article(name, words):
    zone = f"zones: {{{name}: {{shape: circle, centre_m: [0, 0], radius_m: 0.2}}}}"
    said = sentence(f"triggers: [{{trigger: enters, entity: ball, zone: {name}}}], {END}", zone)
    assert said == f"When the ball enters {words}: the half ends."


def test_names_of_robots_are_written_alike_in_text_and_tables():
    robot = "{colour: yellow, number: 4, kit: v2, start: {x_m: 0.5, y_m: 0, yaw_rad: 0}, without: [compass]}"
    text = sheet(
        f"robots: {{goal_keeper: {robot}}}\nentrants: {{yellow: {{robots: {{goal_keeper: keeper.py}}}}}}\n"
        f"rules: {{it: {{triggers: [{{trigger: program_fault, robot: goal_keeper}}], {END}}}}}\n"
    )
    assert "| goal keeper | yellow | program of yellow | v2 |" in text
    assert "goal keeper differs from its kit: no “compass”." in text
    assert "the program of goal keeper fails" in text
    assert "| yellow | goal keeper | keeper.py |" in text
    assert "goal_keeper" not in text.partition("<svg")[0] + text.partition("</svg>")[2]


# --- places that a draw decides on ------------------------------------------------------------------------------------

DRAWN = """
gates: {west: {from_m: [-0.5, 0], to_m: [-0.3, 0]}, east: {from_m: [0.3, 0], to_m: [0.5, 0]}}
draws: {hot: {values: [blue_goal, yellow_goal]}, door: {values: [west, east]}, spot: {values: [centre, middle_blue]}}
"""


@pytest.mark.parametrize(
    ("trigger", "words"),
    [
        (
            "enters, entity: ball, zone: hot",
            "the ball enters the zone drawn as “hot” (the blue goal or the yellow goal)",
        ),
        (
            "leaves, entity: ball, zone: hot",
            "the ball leaves the zone drawn as “hot” (the blue goal or the yellow goal)",
        ),
        (
            "stays_in, entity: ball, zone: [hot, pitch], limit_s: 2",
            "the ball has been in the zone drawn as “hot” (the blue goal or the yellow goal) or the pitch for more than 2 s",
        ),
        (
            "crosses, entity: ball, gate: door",
            "the ball crosses the gate drawn as “door” (the gate “west” or the gate “east”)",
        ),
        (
            "holds, condition: {condition: distance, entity: ball, to: hot, at_most: 0.1}",
            "the ball is at most 0.1 m from the zone drawn as “hot” (the blue goal or the yellow goal)",
        ),
    ],
)
def test_of_a_drawn_place_it_is_said_which_it_may_be(trigger, words):
    assert words in sentence(f"triggers: [{{trigger: {trigger}}}], {END}", DRAWN)


def test_the_distance_to_a_drawn_zone_is_0_inside():
    far = "actions: [{action: score, entrant: blue, points: {distance: [ball, %s]}}]"
    start = "triggers: [{trigger: half_started}], "
    assert "in m (0 inside)" in sentence(start + far % "hot", DRAWN)
    assert "the spot drawn as “spot” in m" in sentence(start + far % "spot", DRAWN)


def test_of_many_drawn_places_the_list_of_draws_says_which():
    many = DRAWN.replace(
        "values: [blue_goal, yellow_goal]",
        "values: [blue_goal, yellow_goal, pitch, blue_penalty_area, yellow_penalty_area]",
    )
    said = sentence(f"triggers: [{{trigger: enters, entity: ball, zone: hot}}], {END}", many)
    assert "enters the zone drawn as “hot”" in said
    assert "yellow penalty area" not in said
