"""What the rule sheet and the picture say of kicks, of looking, of one of several conditions, and of who gets points."""

import pytest

from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.drawing.areas import placement_areas
from rcj_challenges.views.sheet import sheet_markdown

HEAD = "schema_version: 1\nid: shots\ntitle: Shots\nextends: soccersim_v2\n"
IN_GOAL = "{condition: in_zone, entity: ball, zone: blue_goal}"
KICK = "{action: place, entity: ball, at: {spot: centre}, kick: {towards: %s, speed_mps: %s}}"


def loaded(action="{action: end}", conditions="", more="", each=""):
    rule = f"triggers: [{{trigger: half_started}}], conditions: [{conditions}], actions: [{action}]"
    return load_text(f"{HEAD}{more}rules: {{it: {{{each}{rule}}}}}\n")


@pytest.fixture
def sheet(without_drawing):
    """Return what writes the sheet of one rule."""

    def written(*parts, **more):
        one = loaded(*parts, **more)
        return sheet_markdown(one.scenario, one.roster)

    return written


@pytest.mark.parametrize(
    ("towards", "words"),
    [
        ("{point: [0, 0.5]}", "(0, 0.5)"),
        ("{spot: middle_blue}", "the spot “middle blue”"),
        ("{uniform_in: blue_goal}", "a random point of the blue goal"),
        ("{on_line: [[-0.2, 0.7], [0.2, 0.7]]}", "a random point of the line from (-0.2, 0.7) to (0.2, 0.7)"),
        ("{choice: [[0, 0.5], [0.1, 0.5]]}", "(0, 0.5) or (0.1, 0.5)"),
        ("{relative_to: Y1}", "Y1"),
        ("{relative_to: Y1, offset_m: [0.2, 0]}", "the point 0.2 m towards +x of Y1"),
        ("{nearest_free: neutral_spots, to: Y1}", "that free one of the neutral spots which is nearest to Y1"),
        ("start", "its start"),
    ],
)
def test_a_kick_says_how_fast_the_ball_rolls_and_where_to(sheet, towards, words):
    assert f"the ball is put on the spot “centre”, and rolls at 0.6 m/s towards {words}." in sheet(
        KICK % (towards, 0.6)
    )


def test_a_random_speed_says_from_where_to_where(sheet):
    assert ", and rolls at 0.4 to 0.8 m/s towards (0, 0.5)." in sheet(KICK % ("{point: [0, 0.5]}", "[0.4, 0.8]"))


def test_several_balls_roll_each(sheet):
    text = sheet(
        (KICK % ("{point: [0, 0.5]}", 0.6)).replace("entity: ball", "entity: balls"),
        more="balls: {second: {start_m: [0.2, 0]}}\n",
    )
    assert "the balls are each put on the spot “centre”, and each rolls at 0.6 m/s towards (0, 0.5)." in text


@pytest.mark.parametrize(
    ("condition", "words"),
    [
        ("{condition: looks, entity: Y1, towards: ball}", "Y1 looks towards the ball (to within 11.5°)"),
        ("{condition: looks, entity: Y1, towards: ball, negate: true}", "Y1 does not look towards the ball"),
        (
            "{condition: looks, entity: yellow, of: all, heading_rad: 1.5707963}",
            "all of the yellow robots look 90° counter-clockwise from +x (to within 11.5°)",
        ),
        (
            f"{{condition: any_of, conditions: [{IN_GOAL}, {{condition: speed, entity: ball, at_most: 0.1}}]}}",
            "provided that either the ball is in the blue goal or the ball moves at a speed of at most 0.1 m/s",
        ),
        (
            f"{{condition: any_of, negate: true, conditions: [{IN_GOAL}, {IN_GOAL.replace('ball', 'Y1')}]}}",
            "provided that neither the ball is in the blue goal nor Y1 is in the blue goal",
        ),
    ],
)
def test_conditions_are_sentences(sheet, condition, words):
    assert words in sheet(conditions=condition)


def test_who_gets_points_is_said_in_the_rule_and_in_the_table(sheet):
    last = sheet("{action: score, entrant: {last_touch: ball}, points: 2}")
    assert ": the team of the last to touch the ball gets 2 points." in last
    assert "| the team of the last to touch the ball | 2 |" in last
    each = sheet("{action: score, entrant: each}", each="for_each: robots, ")
    assert ": its team gets 1 point." in each
    assert "| its team | 1 |" in each


def test_a_sequence_begins_anew(sheet):
    way = "sequences: {way: {entity: ball, steps: [blue_goal, yellow_goal]}}\n"
    assert ": the sequence “way” begins anew." in sheet("{action: sequence, sequence: way}", more=way)


def test_the_picture_shows_where_a_ball_is_put_and_where_it_rolls_to():
    one = loaded(KICK % ("{on_line: [[-0.2, 0.7], [0.2, 0.7]]}", 0.6))
    assert [(area.words(), who) for area, who in placement_areas(one.scenario, one.roster).items()] == [
        ("rolls towards (-0.2, 0.7) to (0.2, 0.7)", ["ball"])
    ]
    picture = draw_scenario(one.scenario, one.roster)
    assert "<title>roll ball anywhere on this line</title>" in picture
    assert ">ball: rolls towards (-0.2, 0.7) to (0.2, 0.7)<" in picture
