"""The rule sheet says what the referee really does: where mirrored kicks go, what must last, what begins anew."""

import pytest

from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.sheet import sheet_markdown

HEAD = "schema_version: 1\nid: shots\ntitle: Shots\nextends: soccersim_v2\nflags: {away: {}}\n"
KICK = "{action: place, entity: ball, at: %s, mirror: {axis: %s}, kick: {towards: %s, speed_mps: 1}}"
IN_GOAL = "{condition: in_zone, entity: %s, zone: blue_goal%s}"
NOT = ", negate: true"


@pytest.fixture
def sheet(without_drawing):
    """Return what writes the sheet of one rule."""

    def written(action="{action: end}", conditions="", more="", triggers="{trigger: half_started}"):
        rule = f"triggers: [{triggers}], conditions: [{conditions}], actions: [{action}]"
        one = load_text(f"{HEAD}{more}rules: {{it: {{{rule}}}}}\n")
        return sheet_markdown(one.scenario, one.roster)

    return written


# --- mirrored kicks ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("towards", "words"),
    [
        ("start", "its start"),
        ("{point: [0, 0.5]}", "(0, 0.5)"),
        ("{spot: middle_blue}", "the spot “middle blue”"),
        ("{uniform_in: blue_goal}", "a random point of the blue goal"),
        ("{relative_to: middle_blue}", "the spot “middle blue”"),
        ("{relative_to: middle_blue, offset_m: [0.2, 0]}", "the point 0.2 m towards +x of the spot “middle blue”"),
        ("{nearest_free: neutral_spots, to: Y1}", "that free one of the neutral spots which is nearest to Y1"),
    ],
)
def test_where_a_mirrored_ball_rolls_to_is_mirrored_like_its_place(sheet, towards, words):
    text = sheet(KICK % ("{point: [0.1, -0.2]}", "y, when: away", towards))
    assert (
        "the ball is put at (0.1, -0.2), mirrored (y becomes -y) if the flag “away” is set, "
        f"and rolls at 1 m/s towards {words}, mirrored in the same way."
    ) in text


def test_of_an_aim_beside_a_robot_only_the_way_from_it_is_mirrored(sheet):
    text = sheet(KICK % ("{point: [0.1, -0.2]}", "y", "{relative_to: Y1, offset_m: [0.2, 0]}"))
    assert (
        "and rolls at 1 m/s towards the point 0.2 m towards +x of Y1, mirrored in the same way as seen from Y1." in text
    )


@pytest.mark.parametrize(
    ("towards", "words"),
    [
        ("{relative_to: Y1}", "Y1"),
        ("{relative_to: Y1, offset_m: [0.2, 0], turns: true}", "the point 0.2 m to the front of Y1, as Y1 is turned"),
    ],
)
def test_a_robot_that_is_aimed_at_is_not_mirrored(sheet, towards, words):
    text = sheet(KICK % ("{point: [0.1, -0.2]}", "y", towards))
    assert f"mirrored (y becomes -y), and rolls at 1 m/s towards {words}." in text


def test_a_place_beside_a_robot_is_mirrored_as_seen_from_it(sheet):
    text = sheet(KICK % ("{relative_to: Y1, offset_m: [0.2, 0.1]}", "x", "{point: [0, 0.5]}"))
    assert "of Y1, mirrored as seen from Y1 (x becomes -x), and rolls at 1 m/s towards (0, 0.5)" in text


def test_where_only_the_aim_is_mirrored_the_aim_says_how(sheet):
    text = sheet(KICK % ("{relative_to: Y1, offset_m: [0.2, 0], turns: true}", "x", "{point: [0.1, 0.5]}"))
    assert "as Y1 is turned, and rolls at 1 m/s towards (0.1, 0.5), mirrored (x becomes -x)." in text


LAYOUTS = (
    "placements:\n"
    "  shot: [{entity: ball, at: {spot: centre}, kick: {towards: %s, speed_mps: 1}}]\n"
    "  rest: [{entity: ball, at: {spot: centre}}]\n"
    "draws: {which: {values: [shot, rest]}}\n"
)


@pytest.mark.parametrize(
    ("layout", "towards", "words"),
    [
        ("shot", "{point: [0, 0.5]}", "“shot”, places and aims mirrored (y becomes -y)."),
        ("{draw: which}", "{point: [0, 0.5]}", "the layout drawn as “which”, places and aims mirrored (y becomes -y)."),
        ("shot", "{relative_to: Y1}", "“shot”, mirrored (y becomes -y)."),
        ("rest", "{point: [0, 0.5]}", "“rest”, mirrored (y becomes -y)."),
    ],
)
def test_a_mirrored_layout_says_that_its_aims_are_mirrored_too(sheet, layout, towards, words):
    action = f"{{action: place, layout: {layout}, mirror: {{axis: y}}}}"
    assert f"things are put as in {words}" in sheet(action, more=LAYOUTS % towards)


# --- what must last ---------------------------------------------------------------------------------------------------


def holds(*members, more="", times=", for_s: 1"):
    condition = f"{{condition: any_of, conditions: [{', '.join(members)}]{more}}}"
    return f"{{trigger: holds, condition: {condition}{times}}}"


def test_one_of_several_that_must_last_says_so_before_them(sheet):
    members = (IN_GOAL % ("ball", ""), IN_GOAL % ("Y1", ""))
    either = "either the ball is in the blue goal or Y1 is in the blue goal"
    assert f"When for 1 s {either}: " in sheet(triggers=holds(*members))
    graced = holds(*members, times=", for_s: 1, grace_s: 0.2, every_s: 1")
    again = "(interruptions of up to 0.2 s do not count), and again every 1 s while that lasts"
    assert f"When for 1 s {either} {again}: " in sheet(triggers=graced)
    assert f"When {either}: " in sheet(triggers=holds(*members, times=""))
    assert "When the ball is in the blue goal for 1 s: " in sheet(triggers=holds(members[0]))


def test_none_of_several_that_must_last_says_so_before_them(sheet):
    text = sheet(triggers=holds(IN_GOAL % ("ball", ""), IN_GOAL % ("Y1", ""), more=NOT))
    assert "When for 1 s neither the ball is in the blue goal nor Y1 is in the blue goal: " in text


def test_none_of_several_that_are_negated_reads_as_all_of_them(sheet):
    members = (IN_GOAL % ("Y1", NOT), IN_GOAL % ("Y2", NOT), IN_GOAL % ("Y3", NOT))
    three = "Y1 is in the blue goal and Y2 is in the blue goal and Y3 is in the blue goal"
    condition = f"{{condition: any_of, negate: true, conditions: [{', '.join(members)}]}}"
    assert f"provided that {three}: " in sheet(conditions=condition)
    assert f"When for 1 s {three}: " in sheet(triggers=holds(*members, more=NOT))


def test_none_of_several_of_which_one_is_negated_says_what_each_must_be(sheet):
    members = f"{IN_GOAL % ('Y1', NOT)}, {IN_GOAL % ('Y2', '')}"
    text = sheet(conditions=f"{{condition: any_of, negate: true, conditions: [{members}]}}")
    assert "provided that Y1 is in the blue goal and Y2 is not in the blue goal: " in text


def test_not_one_single_condition_is_its_opposite(sheet):
    text = sheet(conditions=f"{{condition: any_of, negate: true, conditions: [{IN_GOAL % ('Y1', '')}]}}")
    assert "provided that Y1 is not in the blue goal: " in text


# --- sequences --------------------------------------------------------------------------------------------------------

WAY = "sequences: {way: {entity: ball, steps: [blue_goal, yellow_goal]%s}}\n"


def test_a_sequence_begins_anew_when_it_is_complete_and_when_a_rule_says_so(sheet):
    moved = "when a rule puts the ball somewhere or takes it off the field."
    assert f"It begins anew when it is complete, and {moved}" in sheet(more=WAY % "")
    reset = sheet("{action: sequence, sequence: way}", more=WAY % ", wrong_step: break")
    assert f"It begins anew also when it is complete, when the rule \\[it\\] says so, and {moved}" in reset


def test_the_last_step_of_a_round_is_the_first_of_the_next(sheet):
    text = sheet(more=WAY % ", cyclic: true")
    assert (
        "Back at the first step it is complete, and the next round has begun. It begins anew when a rule puts the ball "
        "somewhere or takes it off the field."
    ) in text


# --- ways to look, last touches ---------------------------------------------------------------------------------------


def test_a_negative_angle_is_told_clockwise(sheet):
    looks = "{condition: looks, entity: Y1, heading_rad: -1.5708}"
    assert "Y1 looks 90° clockwise from +x (to within 11.5°)" in sheet(conditions=looks)
    faces = "{action: place, entity: Y1, at: {point: [0.1, 0]}, facing: -1.5708}"
    assert "Y1 is put at (0.1, 0), facing 90° clockwise from +x" in sheet(faces)


def test_the_sheet_says_whose_touch_is_the_last(sheet):
    told = (
        "The last to touch something is the robot that touched it last since a rule put it where it is; if none has, there is "
        "none"
    )
    assert f"{told}, and its team's points go to nobody." in sheet("{action: score, entrant: {last_touch: ball}}")
    asked = sheet(conditions="{condition: last_touch, entity: ball, by: Y1}")
    assert f"{told}." in asked
    within = "{condition: any_of, conditions: [{condition: last_touch, entity: ball, by: Y1}]}"
    assert f"{told}." in sheet(conditions=within)
    assert told not in sheet()
