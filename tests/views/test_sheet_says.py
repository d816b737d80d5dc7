"""What a rule says on the sheet, where blanks that are filled when it fires stand for something general."""

import pytest

from tests.views.sheets import section, sheet, spoken

pytestmark = pytest.mark.usefixtures("without_drawing")

END = "actions: [{action: end}]"
THINGS = """
gates: {west: {from_m: [-0.5, 0], to_m: [-0.3, 0]}, east: {from_m: [0.3, 0], to_m: [0.5, 0]}}
groups: {doors: [west, east]}
timers: {rest: {lasts_s: 3, per: robots}}
sequences: {way: {entity: Y3, steps: [blue_goal, yellow_goal]}, round: {per: blue, steps: [blue_goal, yellow_goal]}}
"""
CROSSES = "for_each: doors, triggers: [{trigger: crosses, entity: yellow, gate: each}]"
TOUCHES = "for_each: robots, triggers: [{trigger: touches, entity: each, other: robots}]"
TEAM_TOUCHES = "for_each: entrants, triggers: [{trigger: touches, entity: each, other: others}]"
STILL = "{trigger: holds, conditions: [{speed: each, at_most: 0.01}], for_s: 5%s}"


@pytest.mark.parametrize(
    ("triggers", "words"),
    [
        ("{trigger: enters, entity: Y1, zone: pitch}", "Y1"),
        ("{trigger: displaced, entity: blue, angle_rad: 0.1}", "A blue robot"),
        ("{trigger: enters, entity: Y1, zone: pitch}, {trigger: leaves, entity: ball, zone: pitch}", "Y1 or the ball"),
        ("{trigger: displaced, entity: [yellow, ball], distance_m: 0.1}", "A yellow robot or the ball"),
        ("{trigger: program_fault, robot: Y2}", "Y2"),
        ("{trigger: sequence_completed, sequence: way}", "Y3"),
        ("{trigger: sequence_completed, sequence: round, entity: B2}", "B2"),
        ("{trigger: timer_expired, timer: rest}", "A robot"),
        ("{trigger: time_reached, at_s: 3}", "The one concerned"),
    ],
)
def test_entity_is_what_the_triggers_are_about(triggers, words):
    assert spoken(f"triggers: [{triggers}], {END}, says: '{{entity}} is there.'", THINGS) == f"{words} is there."


@pytest.mark.parametrize(
    ("rule", "says", "words"),
    [
        (CROSSES, "{entity} has passed {each}.", "A yellow robot has passed one of the doors."),
        (CROSSES, "{each} is open; who crosses {each} closes it.", "One of the doors is open; who crosses the gate closes it."),
        (TOUCHES, "{other} is touched.", "The other robot is touched."),
        (TOUCHES, "{each} or {entity}.", "A robot or the robot."),
        (TEAM_TOUCHES, "{each}, by {entity}.", "A team, by one of its robots."),
    ],
)  # fmt: skip
def test_each_and_other_are_named_by_their_kind_or_group(rule, says, words):
    assert spoken(f"{rule}, {END}, says: '{says}'", THINGS) == words


@pytest.mark.parametrize(
    ("rule", "entity", "says", "words"),
    [
        ("for_each: yellow, ", "each", "{team} is alone on the hill.", "Yellow is alone on the hill."),
        ("", "Y1", "A point for {team}.", "A point for yellow."),
        ("", "robots", "A point for {team}.", "A point for the team."),
        ("", "ball", "A point for {team}.", "A point for the team."),
    ],
)
def test_team_is_named_if_all_that_the_rule_is_about_are_of_one(rule, entity, says, words):
    trigger = f"{{trigger: enters, entity: {entity}, zone: blue_goal}}"
    assert spoken(f"{rule}triggers: [{trigger}], {END}, says: '{says}'") == words


@pytest.mark.parametrize(
    ("trigger", "words"),
    [
        (STILL % "", "5 of 5 s."),
        (STILL % ", every_s: 2", "… of 5 s."),
        ("{trigger: timer_expired, timer: rest, entity: each}", "3 of 3 s."),
        ("{trigger: time_reached, at_s: 3}, {trigger: time_reached, at_s: 4}", "… of … s."),
    ],
)
def test_numbers_that_are_known_only_when_it_fires_are_left_open(trigger, words):
    said = f"for_each: robots, triggers: [{trigger}], {END}, says: '{{measured}} of {{limit}} s.'"
    assert spoken(said.replace(", entity: each}]", "}]") if "timer_expired" in trigger else said, THINGS) == words


@pytest.mark.parametrize(
    ("says", "words"), [("goal", "Goal."), ("Goal!", "Goal!"), ("goal (once)", "Goal (once)."), ('"goal."', '"goal."')]
)
def test_it_is_a_whole_sentence(says, words):
    assert spoken(f"triggers: [{{trigger: half_started}}], {END}, says: '{says}'") == words


def test_the_sheet_has_a_sentence_of_its_own_where_what_is_so_is_not_what_has_happened():
    more = "counters: {fouls: {per: entrants}}\nroles: {wanted: {of: [Y1, Y2], order: listed}}"
    rule = f"for_each: entrants, triggers: [{{trigger: half_started}}], {END}, says: '{{each}} has {{fouls}} fouls'"
    assert spoken(rule, more) == "A team has … fouls."
    assert spoken(f"{rule}, sheet: 'After 3 fouls {{others}} gets {{wanted}}, not the team {{each}}; {{each}} waits.'", more) == (
        "After 3 fouls the other team gets the wanted, not a team; the team waits."
    )  # fmt: skip


def test_a_draw_is_open_or_what_is_drawn():
    rule = f"triggers: [{{trigger: half_started}}], {END}, says: '{{target}} is worth {{bonus}} points.'"
    draws = "draws: {bonus: {values: [1, 2]}, target: {values: [blue_goal, yellow_goal]}}"
    assert spoken(rule, draws) == "The zone drawn as “target” is worth … points."


def test_a_role_of_other_things_than_robots_is_named_with_its_kind():
    rule = f"triggers: [{{trigger: half_started}}], {END}, says: '{{delivered}} waits for {{thrower}}'"
    roles = "roles: {delivered: {of: [ball]}, thrower: {of: robots}}"
    assert spoken(rule, roles) == "The ball “delivered” waits for the thrower."


def test_copies_of_a_rule_say_the_same_in_general_words():
    text = """
tables:
  teams: {blue: {basket: yellow_goal, worth: 2.5}, yellow: {basket: blue_goal, worth: 2.5}}
rules:
  it:
    repeat_for: teams
    triggers: [{trigger: enters, entity: ball, zone: {param: basket}}]
    actions: [{action: end}]
    says: "The ball is in the {basket}, worth {worth}: {this} is ahead, and {teams} lines up."
"""
    said = "- The ball is in its basket, worth 2.5: a team is ahead, and the team lines up."
    assert section(sheet(text), "Rules") == said
    both = said + "\n" + said.replace("2.5", "3")
    assert section(sheet(text.replace("goal, worth: 2.5}}", "goal, worth: 3}}")), "Rules") == both
    assert section(sheet(text + "    sheet: '{this} wins'\n"), "Rules") == "- A team wins."


def test_in_a_rule_for_robots_others_get_points_as_the_other_team():
    rule = "rules: {it: {for_each: robots, triggers: [{trigger: touches, entity: each, other: walls}], %s}}\n"
    assert "| 1 for the other team |" in sheet(rule % "actions: [{action: score, entrant: others}], says: Bang.")


def test_points_and_params_are_filled_in():
    score = "actions: [{action: score, entrant: blue, points: {param: n}}], says: '{points} points, {n}.'"
    rule = f"rules: {{it: {{triggers: [{{trigger: half_started}}], {score}}}}}\n"
    assert "| 1 point, 1. | 1 for blue |" in sheet(f"params: {{n: 1}}\n{rule}")
