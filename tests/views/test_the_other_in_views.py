"""The one that is touched, in the sheet and in the picture."""

import pytest

from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.drawing.areas import placement_areas
from tests.views.sheets import HEAD, sentence, sheet

MORE = "flags: {catcher: {per: robots}}\ncounters: {hits: {per: robots}}\n"


def said(part: str, touched: str = "robots", trigger: str = "for_each: robots, triggers: [{trigger: touches, entity: each, other: %s}]"):  # fmt: skip
    return sentence(f"{trigger % touched}, {part}", MORE)


def done(action: str, touched: str = "robots", **parts: str) -> str:
    return said(f"actions: [{{action: {action}}}]", touched, **parts).partition(": ")[2]


def asked(condition: str, touched: str = "robots") -> str:
    text = said(f"conditions: [{{condition: {condition}}}], actions: [{{action: end}}]", touched)
    return text.partition("provided that ")[2].partition(": ")[0]


@pytest.mark.parametrize(
    ("action", "words"),
    [
        ("set_flag, flag: catcher, entity: other", "the flag “catcher” of the robot it touches is set."),
        ("count, counter: hits, entity: other", "the counter “hits” of the robot it touches grows by 1."),
        ("remove, entity: other", "the robot it touches is taken off the field."),
        ("score, entrant: other", "the team of the robot it touches gets 1 point."),
        ("place, entity: other, at: {relative_to: each, offset_m: [0, 0.2]}",
         "the robot it touches is put 0.2 m towards +y of it."),
        ("place, entity: each, at: start, facing: {towards: other}", "it is put at its start, facing the robot it touches."),
        ("emit, event: E, payload: {who: {word: other_name}}", "E is announced (who: the name of the other one)."),
    ],
)  # fmt: skip
def test_what_happens_to_it_is_said_of_the_robot_that_is_touched(action, words):
    assert done(action) == words


@pytest.mark.parametrize(
    ("condition", "words"),
    [
        ("flag, flag: catcher, entity: other, negate: true", "the flag “catcher” of the robot it touches is not set"),
        ("looks, entity: each, towards: other", "it looks towards the robot it touches (to within 11.5°)"),
        ("last_touch, by: other", "the last to touch the ball was the robot it touches"),
        ("in_zone, entity: [each, other], zone: blue_goal, of: all",
         "both it and the robot it touches are in the blue goal"),
    ],
)  # fmt: skip
def test_what_is_asked_of_it_is_said_of_the_robot_that_is_touched(condition, words):
    assert asked(condition) == words


def test_a_touch_that_is_heard_again_says_how_often():
    again = "for_each: robots, triggers: [{trigger: touches, entity: each, other: %s, every_s: 0.5}]"
    text = said("actions: [{action: end}]", "ball", trigger=again)
    assert "when it touches the ball, and again every 0.5 s while they touch: the half ends" in text


def test_it_is_called_by_what_it_can_be():
    remove = "remove, entity: other"
    assert done(remove, "[robots, ball]") == "what it touches is taken off the field."
    assert done(remove, "ball") == "the ball is taken off the field."
    assert done(remove, "B1") == "B1 is taken off the field."
    ball = "triggers: [{trigger: touches, entity: ball, other: %s}]"
    assert done(remove, trigger=ball) == "the robot touched is taken off the field."


def test_a_sentence_of_the_rule_names_the_other_one():
    end = "actions: [{action: end}], says: '{entity} has caught {other}.'"
    assert said(end).startswith("The robot has caught the other robot. For each of the robots,")
    assert said(end, "ball").startswith("The robot has caught the ball.")
    assert said(end, "[walls, ball]").startswith("The robot has caught a wall or the ball.")


def test_what_another_kind_of_thing_touches_is_no_other_one_of_its_kind():
    end = "actions: [{action: end}], says: '{entity} has hit {other}.'"
    hits = "triggers: [{trigger: touches, entity: ball, other: %s}]"
    assert said(end, trigger=hits).startswith("The ball has hit the robot.")
    hits = "for_each: balls, triggers: [{trigger: touches, entity: each, other: %s}]"
    assert said(end, trigger=hits).startswith("The ball has hit the robot.")


def test_the_table_of_points_says_whose_team_gets_them():
    rule = "rules: {it: {for_each: robots, triggers: [{trigger: touches, entity: each, other: robots}], actions: [{action: score, entrant: other}]}}"
    assert "| the team of the robot it touches | 1 |" in sheet(rule)


@pytest.mark.parametrize(
    ("rule", "who"),
    [
        ("triggers: [{trigger: touches, entity: ball, other: [yellow, B1]}]", ["yellow", "B1"]),
        ("for_each: blue, triggers: [{trigger: touches, entity: ball, other: each}]", ["blue"]),
    ],
)
def test_the_picture_names_who_may_be_put_somewhere_as_the_trigger_does(rule, who):
    put = "actions: [{action: place, entity: other, at: {point: [0.1, 0.2]}}]"
    one = load_text(f"{HEAD}rules: {{it: {{{rule}, {put}}}}}\n")
    assert list(placement_areas(one.scenario, one.roster).values()) == [who]
    assert "(0.1, 0.2)" in draw_scenario(one.scenario, one.roster)


def test_the_legend_names_who_may_be_the_other_beside_which_something_is_put():
    action = "{action: place, entity: ball, at: {relative_to: other, offset_m: [0.1, 0]}}"
    rule = f"triggers: [{{trigger: touches, entity: ball, other: [Y1, B1]}}], actions: [{action}]"
    one = load_text(f"{HEAD}rules: {{it: {{{rule}}}}}\n")
    assert [area.words() for area in placement_areas(one.scenario, one.roster)] == ["(0.1, 0) from Y1 or B1"]


@pytest.mark.parametrize(
    ("who", "touched", "tail"),
    [
        ("other", "robots", " (of several touched at once only the first counts)"),
        ("other", "B1", ""),
        ("each", "robots", ""),
    ],
)
def test_a_rule_that_excludes_itself_says_that_it_counts_for_the_first_only(who, touched, tail):
    text = said(f"exclusive: once, actions: [{{action: remove, entity: {who}}}]", touched)
    assert text.endswith(f" is taken off the field{tail}.")
